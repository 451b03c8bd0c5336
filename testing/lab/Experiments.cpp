// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/Experiments.h"

namespace palpate::lab
{

std::vector<Experiment> experiments()
{
  return {
    { "wall-stability",
      "the stiffness at which a sampled wall begins to shake is that of exact eigenvalues, at nine rates", { 1, 2 },
      runWallStability },
    { "stability-atlas", "how stiff a wall may be against rate, delay, damping, encoder step and friction", { 1, 2, 6 },
      runStabilityAtlas },
    { "energy-leak", "a held spring gives K v T (p - v T / 2) to a hand that presses and lets go", { 3 },
      runEnergyLeak },
    { "bounce", "a mass thrown at a held wall comes back faster, at one under control it does not", { 4, 5 },
      runBounce },
    { "limit-cycles", "where damping and friction keep a quantised wall still, and where it cycles", { 6 },
      runLimitCycles },
    { "velocity-estimators", "what an encoder lets one know of a velocity, how late, and the damping that allows",
      { 7 }, runVelocityEstimators },
    { "transparency", "what each stabiliser costs a hand in drag and impedance, and the stiffness it brings", { 58 },
      runTransparency },
    { "speed-accuracy", "every contact method on every scene: what a tick costs, and whether a hand feels its error",
      { 8, 9, 10, 11, 13, 14, 15, 16, 17, 19 }, runSpeedAccuracy },
    { "thin-plate", "a push far beyond a thin plate is held by the side it came from", { 8 }, runThinPlate },
    { "tunnelling", "nothing passes a sheet without thickness at 10 m/s; what is looked at once a tick does", { 9 },
      runTunnelling },
    { "convex-edge", "over the edge of a box: released where the edge is", { 10 }, runConvexEdge },
    { "corners", "concave corners, almost flat valleys and narrow wedges are exact in one tick", { 11, 12, 13 },
      runCorners },
    { "tessellated-plane", "the inner edges of a plane cannot be felt", { 14 }, runTessellatedPlane },
    { "soup", "damaged meshes feel like whole ones, and a ball bridges gaps", { 15 }, runSoup },
    { "scale", "the unit and the place of a scene change nothing", { 16 }, runScale },
    { "facets", "what the facets of a sphere do to the force on it, and what a tick costs", { 17 }, runFacets },
    { "force-shading", "smooth forces over facets: no jumps from face to face, and how little work a closed way does", { 18 }, runForceShading },
    { "groove", "a ball hangs in a groove at its radius and rolls over an edge on an arc", { 19, 20 }, runGroove },
    { "queries", "which libraries answer a collision query rightly, and what an answer costs", { 54 }, runQueries },
    { "solver", "the nearest point in front of many planes: enumeration is exact, two textbook methods are not",
      { 11, 12, 13 }, runSolver },
    { "tick-cost", "what an exact tick of sliding contact does, and its cost beside one query of CGAL", { 54 }, runTickCost },
    { "replay", "a recording with scene swaps gives the same bits again, with any number of workers", { 55 }, runReplay },
    { "recorded-touch", "touches known by a formula, pushed in and rendered, give their forces back", { 56 }, runRecordedTouch },
    { "smooth-input", "a hand that moves smoothly feels nothing that is faster than its own motion", { 57 }, runSmoothInput },
    { "friction", "what sticks stays for ever, breaks away where Coulomb says, and rubs off the energy of its loop",
      { 23, 24, 26 }, runFriction },
    { "moving", "nothing passes a surface that comes, closes or turns: it carries the hand, and rubs by its own motion",
      { 21, 22, 25 }, runMoving },
    { "many-surfaces", "a scene of up to a thousand surfaces is felt as the one mesh of them all, at about its cost",
      { 54 }, runManySurfaces },
    { "closed-loop", "a hand gets no more out of a loop in a convex room than a held force leaks", { 27 }, runClosedLoop },
    { "materials", "data felt as they say: soft and hard, rough and fast, and no work from a loop over any of it", { 27 },
      runMaterials },
    { "deforming", "a surface whose vertices move stays felt, at a fraction of what building it anew costs", { 51 },
      runDeforming },
    { "scene-swap", "surfaces replaced ten times a second under a pressed hand: it stays, and its force never jumps",
      { 51 }, runSceneSwap },
  };
}

} // namespace palpate::lab
