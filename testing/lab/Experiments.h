// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "testing/lab/Experiment.h"

namespace palpate::lab
{

// One function per file of experiments/, in the order of a report (Experiments.cpp).
void runWallStability(const Conditions& conditions, Table& table);
void runStabilityAtlas(const Conditions& conditions, Table& table);
void runEnergyLeak(const Conditions& conditions, Table& table);
void runAdmittance(const Conditions& conditions, Table& table);
void runArms(const Conditions& conditions, Table& table);
void runBounce(const Conditions& conditions, Table& table);
void runLimitCycles(const Conditions& conditions, Table& table);
void runVelocityEstimators(const Conditions& conditions, Table& table);
void runTransparency(const Conditions& conditions, Table& table);
void runSpeedAccuracy(const Conditions& conditions, Table& table);
void runThinPlate(const Conditions& conditions, Table& table);
void runTunnelling(const Conditions& conditions, Table& table);
void runConvexEdge(const Conditions& conditions, Table& table);
void runCorners(const Conditions& conditions, Table& table);
void runTessellatedPlane(const Conditions& conditions, Table& table);
void runSoup(const Conditions& conditions, Table& table);
void runScale(const Conditions& conditions, Table& table);
void runFacets(const Conditions& conditions, Table& table);
void runForceShading(const Conditions& conditions, Table& table);
void runGroove(const Conditions& conditions, Table& table);
void runQueries(const Conditions& conditions, Table& table);
void runSolver(const Conditions& conditions, Table& table);
void runTickCost(const Conditions& conditions, Table& table);
void runReplay(const Conditions& conditions, Table& table);
void runRecordedTouch(const Conditions& conditions, Table& table);
void runSmoothInput(const Conditions& conditions, Table& table);
void runFriction(const Conditions& conditions, Table& table);
void runMoving(const Conditions& conditions, Table& table);
void runManySurfaces(const Conditions& conditions, Table& table);
void runClosedLoop(const Conditions& conditions, Table& table);
void runMaterials(const Conditions& conditions, Table& table);
void runDeforming(const Conditions& conditions, Table& table);
void runCurves(const Conditions& conditions, Table& table);
void runSceneSwap(const Conditions& conditions, Table& table);
void runPlaneCost(const Conditions& conditions, Table& table);
void runPlayedWalls(const Conditions& conditions, Table& table);
void runPlaneWedge(const Conditions& conditions, Table& table);
void runImageCurves(const Conditions& conditions, Table& table);
void runSlantedWall(const Conditions& conditions, Table& table);
void runCorridor(const Conditions& conditions, Table& table);
void runPlan(const Conditions& conditions, Table& table);
void runSmallestFeature(const Conditions& conditions, Table& table);
void runBlindSolver(const Conditions& conditions, Table& table);
void runIntegralWall(const Conditions& conditions, Table& table);
void runImpactWalls(const Conditions& conditions, Table& table);
void runLinkBudget(const Conditions& conditions, Table& table);
void runSwitchedSprings(const Conditions& conditions, Table& table);
void runFields(const Conditions& conditions, Table& table);
void runFieldBlocks(const Conditions& conditions, Table& table);
void runTurningStability(const Conditions& conditions, Table& table);
void runToolCoupling(const Conditions& conditions, Table& table);
void runToolDrag(const Conditions& conditions, Table& table);
void runToolMethods(const Conditions& conditions, Table& table);
void runSoftLines(const Conditions& conditions, Table& table);
void runLocking(const Conditions& conditions, Table& table);
void runPatch(const Conditions& conditions, Table& table);
void runPackets(const Conditions& conditions, Table& table);
void runMultirate(const Conditions& conditions, Table& table);
void runStruck(const Conditions& conditions, Table& table);
void runContacts(const Conditions& conditions, Table& table);
void runConstraints(const Conditions& conditions, Table& table);
void runMechanism(const Conditions& conditions, Table& table);
void runBodiesMeet(const Conditions& conditions, Table& table);
void runLoose(const Conditions& conditions, Table& table);
void runInertia(const Conditions& conditions, Table& table);
void runMechanismMethods(const Conditions& conditions, Table& table);
void runDirectCoupling(const Conditions& conditions, Table& table);
void runMaterialsLarge(const Conditions& conditions, Table& table);
void runMapping(const Conditions& conditions, Table& table);
void runWire(const Conditions& conditions, Table& table);
void runCapstan(const Conditions& conditions, Table& table);
void runStretchTransition(const Conditions& conditions, Table& table);
void runWirePackets(const Conditions& conditions, Table& table);

} // namespace palpate::lab
