// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/Experiments.h"

namespace palpate::lab
{
namespace
{

/// Walls, dampers and estimators in front of a hand.
std::vector<Experiment> forceExperiments()
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
    { "integral-wall",
      "a wall that walks a pressing hand back to its surface: how fast it may, and what it gives a hand", { 89 },
      runIntegralWall },
    { "impact-walls",
      "a pulse that brakes and a transient make an impact feel hard: how hard, and what a wrong mass or speed costs",
      { 89 }, runImpactWalls },
    { "admittance",
      "a robot with a force sensor is rigid at a wall, heavy in air, and shakes in a grip that is too stiff", { 86 },
      runAdmittance },
    { "arms", "of the same links and motors a parallel arm is lighter and more even, a serial one has more room",
      { 87 }, runArms },
  };
}

/// Contact against truths of geometry.
std::vector<Experiment> contactExperiments()
{
  return {
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
    { "force-shading", "smooth forces over facets: no jumps from face to face, and how little work a closed way does",
      { 18 }, runForceShading },
    { "groove", "a ball hangs in a groove at its radius and rolls over an edge on an arc", { 19, 20 }, runGroove },
  };
}

/// Whole scenes, sessions and materials.
std::vector<Experiment> sceneExperiments()
{
  return {
    { "queries", "which libraries answer a collision query rightly, and what an answer costs", { 54 }, runQueries },
    { "solver", "the nearest point in front of many planes: enumeration is exact, two textbook methods are not",
      { 11, 12, 13 }, runSolver },
    { "tick-cost", "what an exact tick of sliding contact does, and its cost beside one query of CGAL", { 54 },
      runTickCost },
    { "replay", "a recording with scene swaps gives the same bits again, with any number of workers", { 55 },
      runReplay },
    { "recorded-touch", "touches known by a formula, pushed in and rendered, give their forces back", { 56 },
      runRecordedTouch },
    { "smooth-input", "a hand that moves smoothly feels nothing that is faster than its own motion", { 57 },
      runSmoothInput },
    { "friction", "what sticks stays for ever, breaks away where Coulomb says, and rubs off the energy of its loop",
      { 23, 24, 26 }, runFriction },
    { "moving", "nothing passes a surface that comes, closes or turns: it carries the hand, and rubs by its own motion",
      { 21, 22, 25 }, runMoving },
    { "many-surfaces", "a scene of up to a thousand surfaces is felt as the one mesh of them all, at about its cost",
      { 54 }, runManySurfaces },
    { "closed-loop", "a hand gets no more out of a loop in a convex room than a held force leaks", { 27 },
      runClosedLoop },
    { "materials", "data felt as they say: soft and hard, rough and fast, and no work from a loop over any of it",
      { 27 }, runMaterials },
    { "deforming", "a surface whose vertices move stays felt, at a fraction of what building it anew costs", { 51 },
      runDeforming },
  };
}

/// Plane worlds, curves and plans.
std::vector<Experiment> planeExperiments()
{
  return {
    { "plane-cost",
      "a tick among up to a million lines by a tree and by asking every line, and what coarser lines save",
      { 44, 49, 54 }, runPlaneCost },
    { "played-walls",
      "plane worlds played: walls held by a joystick behind a host at 20 to 1000 Hz, a hand led to a plane", { 46, 47 },
      runPlayedWalls },
    { "plane-wedge",
      "a point among lines is exact in a tick, in any order, crosses none and goes round ends like a string",
      { 44, 45 }, runPlaneWedge },
    { "image-curves", "the contour of an image is as exact as its pixels allow, and simpler than a hand can feel",
      { 49 }, runImageCurves },
    { "slanted-wall", "a slanted line held as two walls drags by what the host's rate says", { 46 }, runSlantedWall },
    { "corridor", "a handle between two held walls comes to rest with the least viscosity that is found for it", { 47 },
      runCorridor },
    { "link-budget", "how many forces and walls a second a serial link of 31,250 baud carries to a joystick", { 90 },
      runLinkBudget },
    { "switched-springs",
      "walls of springs that pull as well as push: switched by the host they give and take the same in the mean",
      { 90 }, runSwitchedSprings },
    { "soft-lines", "lines that push back as deep as a hand is in them let it through their corners", { 90 },
      runSoftLines },
    { "smallest-feature", "the narrowest corridor a hand can tell apart, and the zoom that makes a scene feelable",
      { 59 }, runSmallestFeature },
    { "blind-solver", "a hand that knows no walls finds its way through every maze, by force and position alone", {},
      runBlindSolver },
    { "curves", "fibres are cylinders, bends are two at once, and no net or spring is passed at any speed", {},
      runCurves },
    { "plan", "how large a ball may be, when a tree is worth it, and what a proven simpler surface feels like", {},
      runPlan },
    { "scene-swap", "surfaces replaced ten times a second under a pressed hand: it stays, and its force never jumps",
      { 51 }, runSceneSwap },
  };
}

/// Numbers in space.
std::vector<Experiment> fieldExperiments()
{
  return {
    { "fields", "numbers in space by a proxy, by maps of force, by followers and as a mesh; where sampled maps shake",
      { 82, 83, 84 }, runFields },
    { "brick", "how true the numbers around a hand are, what they cost, and how fast a hand may go before they end", {},
      runFieldBlocks },
  };
}

/// Soft bodies.
std::vector<Experiment> softExperiments()
{
  return {
    { "locking", "a bar of tetrahedra that bends: linear ones are too stiff, edge-smoothed ones are not", { 36 },
      runLocking },
    { "patch", "under a patch compliance has a limit as the mesh gets finer, under a node it has none", { 37 },
      runPatch },
    { "packets", "a hand outruns the vertices of its packet: it feels the nearest of them, not a rigid body", { 40 },
      runPackets },
    { "multirate", "a body that is computed ten times a second: by its compliance, by a held force, by a spring to it",
      { 40 }, runMultirate },
    { "struck", "a body with a mass, computed at a low rate: what a hand feels of it, and of an impact", { 69 },
      runStruck },
    { "contacts", "contacts that share compliance: what the tick's solver leaves open, and what it costs", { 38, 42 },
      runContacts },
    { "laws", "each law between two bodies is its closed form, in any hand, turn and tissue", { 64 }, runConstraints },
    { "mechanism",
      "a needle through a wall and an organ: what they share, and what an operator without that makes of it",
      { 65, 66 }, runMechanism },
    { "mechanism-methods",
      "a needle that is swayed as a lever, by each method: the cost of a tick and the error of the force", { 65 },
      runMechanismMethods },
    { "bodies-meet",
      "a mesh ball that presses a soft pad, by each method: the cost of a tick and the error of the force", {},
      runBodiesMeet },
    { "loose", "boxes on a slope and on one another stay or go as statics says; friction as a damper creeps", {},
      runLoose },
    { "inertia", "a loose body in the hand: the force of its inertia, how stiffly it may be held, and shorter ticks",
      { 67 }, runInertia },
    { "direct-coupling", "an object that is stable alone and not when it is touched, and one whose force is held",
      { 67, 68 }, runDirectCoupling },
    { "materials-large", "laws of elasticity turned, pulled and pressed far: which of them lie", { 70, 71, 72 },
      runMaterialsLarge },
    { "mapping", "forces go back by the transpose of the map, or a hand gets torque and energy for nothing", { 77 },
      runMapping },
    { "wire", "a wire that bends far, rolls up, buckles and is turned in a tube; a linear beam goes 3.3 lengths aside",
      { 75 }, runWire },
    { "capstan", "a limp wire slides round a drum: the tension of each corner, and the exponential it goes to", {},
      runCapstan },
    { "stretch-transition", "a hand pulls a slack wire taut: felt in the tick, and not noticed by packets", { 76 },
      runStretchTransition },
    { "wire-packets", "a wire is pushed into a bent tube: whole in each tick, or as packets of another rate", { 43 },
      runWirePackets },
  };
}

/// Rigid tools that turn.
std::vector<Experiment> toolExperiments()
{
  return {
    { "tool-methods",
      "a cube, a peg, a bar and a nut by points, penalties, careful steps and planes: where they end, at what cost",
      { 29, 31, 32 }, runToolMethods },
    { "tool-drag",
      "what a hand feels of a tool between two updates: nothing holds it back in a slide, where a coupling does",
      { 30, 61 }, runToolDrag },
    { "tool-coupling",
      "how stiff a coupling may hold a tool that has a mass of its own, and that an implicit one has no limit", { 34 },
      runToolCoupling },
    { "turning-stability", "how stiff a spring may hold the turn of a handle, against rate and hand", { 1 },
      runTurningStability },
  };
}

} // namespace

std::vector<Experiment> experiments()
{
  std::vector<Experiment> all;
  for (const auto& group : { forceExperiments(), contactExperiments(), sceneExperiments(), planeExperiments(),
         fieldExperiments(), softExperiments(), toolExperiments() })
  {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

} // namespace palpate::lab
