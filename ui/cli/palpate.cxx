// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

#include "haptics/session/settings/SessionSettings.h"
#include "vtkHapticCliCommands.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticMechanismFile.h"
#include "vtkVersion.h"

namespace
{
constexpr int BadInput = 2;

struct Arguments
{
  bool DevicesJson = false;
  std::string SelfTest;
  bool Keep = false;
  bool Wheel = false;
  vtkHapticCliCheckOptions Check;
  vtkHapticCliTouchOptions Touch;
  vtkHapticCliReplayOptions Replay;
  vtkHapticCliLabyrinthOptions Labyrinth;
  vtkHapticCliTurnOptions Turn;
  std::string Arm;
  bool ArmJson = false;
};

void AddArm(CLI::App& app, Arguments& arguments)
{
  CLI::App* command = app.add_subcommand(
    "arm", "Check an arm file, and print condition, largest force and apparent mass over the work space");
  command->add_option("FILE", arguments.Arm, "Arm file (json), or the name of a built-in arm, such as falcon")
    ->required();
  command->add_flag("--json", arguments.ArmJson, "Print JSON");
}

void AddDevices(CLI::App& app, Arguments& arguments)
{
  CLI::App* command = app.add_subcommand(
    "devices", "List the attached devices, their functions, and the reason why a device cannot be used");
  CLI::Option* json = command->add_flag("--json", arguments.DevicesJson, "Print JSON");
  CLI::Option* test = command->add_option("--self-test", arguments.SelfTest,
    "Check the device ID together with its user; a simulated hand follows the instructions by itself");
  test->excludes(json);
  command->add_flag("--keep", arguments.Keep, "Save the result of the check; later sessions apply it")->needs(test);
  command->add_flag("--wheel", arguments.Wheel, std::string(palpate::sessionSetting("Wheel").sentence))->needs(test);
}

void AddCheck(CLI::App& app, Arguments& arguments)
{
  vtkHapticCliCheckOptions& options = arguments.Check;
  CLI::App* command = app.add_subcommand("check", "Check whether a file can be touched, and list repairs and refusals");
  command
    ->add_option("FILE", options.File,
      "Surfaces (vtp, vtu, stl, ply, obj, off), images with --iso (vti, nii, nii.gz), lines (vtp, svg, png), "
      "mechanisms (json)")
    ->required();
  command->add_option("--iso", options.Iso, "Isovalue that extracts the surface from an image");
  options.Settings.Add(*command, "Radius", "the report says whether this radius fits");
  command->add_flag(
    "--force-radius", options.ForceRadius, "Use the radius as set, even if a tick may exceed its work limit");
  options.Settings.Add(*command, "LineRadius", "at 0, lines are walls perpendicular to the plane z = 0");
  options.Settings.Add(*command, "FrictionStatic");
  options.Settings.Add(*command, "FrictionKinetic", "default: the static coefficient");
  options.Settings.AddMaterials(*command);
  command->add_option("--thin", options.Thin_u, "List walls of a closed surface thinner than this [u]")
    ->check(CLI::NonNegativeNumber);
  options.Settings.Add(*command, "MechanismTurning");
  command->add_flag(
    "--simplify", options.Simplify, "Report the smallest number of triangles that is proven to feel the same");
  command->add_flag("--json", options.Json, "Print JSON");
}

/// Tool, soft body and mechanism: each option names its group of the help text.
void AddTouchedBodies(CLI::App& command, vtkHapticCliTouchOptions& options)
{
  command.option_defaults()->group("Tool");
  CLI::Option* tool =
    command.add_option("--tool", options.Tool, "Rigid mesh in the hand; the hand holds the origin of its data");
  CLI::Option& lever = options.Settings.Add(command, "ToolLever");
  lever.needs(tool);
  command
    .add_flag("--virtual-coupling", options.VirtualCoupling,
      "With --tool: render the spring between tool and hand in place of the contact forces")
    ->needs(tool);
  command.option_defaults()->group("Loose body");
  CLI::Option* loose = command.add_option(
    "--loose", options.Loose, "Closed surface that is a loose body, which has mass. One unit is 1 / --scale metres");
  CLI::Option* density =
    command.add_option("--density", options.Density, "With --loose: density, above 0 and at most 1e6 [kg/m3]");
  loose->needs(density);
  density->needs(loose);
  command.option_defaults()->group("Soft body");
  CLI::Option* young = command.add_option("--young", options.Soft.Young_Pa,
    "Make FILE (vtu or closed surface) a soft body with this Young's modulus, 10 to below 1e12 [Pa]. One unit is 1 / "
    "--scale metres");
  command.add_option("--poisson", options.Soft.Poisson, "With --young: Poisson's ratio, 0 to below 0.5")
    ->capture_default_str()
    ->needs(young);
  command
    .add_option("--fixed", options.Soft.Fixed,
      "With --young: fixed points, as sides of the bounding box (xmin,xmax,ymin,ymax,zmin,zmax) or a point array")
    ->needs(young);
  command
    .add_option("--model", options.Soft.Model, "With --young: constitutive model, linear, corotational or neohookean")
    ->capture_default_str()
    ->check(CLI::IsMember({ "linear", "corotational", "neohookean" }))
    ->needs(young);
  command.option_defaults()->group("Mechanism");
  options.Settings.Add(command, "MechanismTurning", "with --tool, in place of --lever").excludes(&lever);
  options.Settings.Add(
    command, "SoftRate", "in virtual time, also with --young; 0: solve to equilibrium in every tick");
}

void AddTouch(CLI::App& app, Arguments& arguments)
{
  vtkHapticCliTouchOptions& options = arguments.Touch;
  CLI::App* command =
    app.add_subcommand("touch", "Compute contact along a path of the device, one tick per row, without device limits");
  command
    ->add_option("FILE", options.Files,
      "Surfaces, images (with --iso), lines (vtp, svg, png; with --two-d or --line-radius), or one mechanism (json)")
    ->required();
  command->option_defaults()->group("Input");
  command
    ->add_option("--path", options.Path,
      "Path of the device: PATH.csv with columns t,x,y,z[,qw,qx,qy,qz] [s, u], one tick per row")
    ->required();
  command->add_option(
    "--iso,--value", options.Iso, "Isovalue that extracts the surface from an image, or of --mode isosurface");
  command->add_flag("--two-d", options.TwoD, "Render lines in the plane z = 0 as walls, touched in that plane");
  options.Settings.AddAll(*command);
  command->option_defaults()->group("Field");
  vtkHapticCliAddField(*command, options.Field);
  AddTouchedBodies(*command, options);
  command->option_defaults()->group("Output");
  command->add_option("--csv", options.Output, "OUT.csv with one row per tick")->required();
}

void AddReplay(CLI::App& app, Arguments& arguments)
{
  vtkHapticCliReplayOptions& options = arguments.Replay;
  CLI::App* command = app.add_subcommand("replay", "Recompute a recording and compare it bit for bit");
  command->add_option("RECORDING", options.Recording, "Recording, as saved by a session")->required();
  command->add_option("--scene", options.Scenes, "Surfaces, for a recording without scenes");
  command->add_option("--iso", options.Iso, "Isovalue that extracts the surface from an image");
  command->add_option("--csv", options.Output, "Output: OUT.csv with one recomputed row per tick");
}

void AddLabyrinth(CLI::App& app, Arguments& arguments)
{
  vtkHapticCliLabyrinthOptions& options = arguments.Labyrinth;
  CLI::App* command = app.add_subcommand("labyrinth", "Describe a labyrinth, solve it, or play it");
  command->add_option(
    "FILE", options.File, "Lines in the plane z = 0, or a name from the gallery. Default: the whole gallery");
  CLI::Option* solve = command->add_flag("--solve", options.Solve, "Let a simulated hand find the exit by touch alone");
  command
    ->add_option("--path", options.Path, "Path of the device: PATH.csv with columns t,x,y,z [s, u], one tick per row")
    ->excludes(solve);
  command->add_option("--csv", options.Output, "Output: TRACE.csv with the path of the hand");
  command->add_option("--corridor", options.Corridor_u, "Width of the corridors [u]");
  CLI::Option* play = command->add_flag("--play", options.Play,
    "Play from the device alone: button n starts labyrinth n (FILE, or the gallery in order), the next button ends");
  play->excludes(solve)->excludes("--path");
  command->add_option("--hold", options.Hold,
    "With --play: dead-man switch, the number of a button or grip (default: the button that chose the labyrinth)");
  command->add_option("--device", options.Device,
    "Device of the simulated hand (default: simulated-joystick); with --play: the device (default: the attached one)");
  command->add_option("--host", options.Host_Hz, "Update rate of the host [Hz]")->capture_default_str();
  command->add_flag("--device-walls", options.DeviceWalls, "Let the device hold the walls in its own loop");
}

void AddTurn(CLI::App& app, Arguments& arguments)
{
  vtkHapticCliTurnOptions& options = arguments.Turn;
  CLI::App* command = app.add_subcommand("turn", "Feel a value along a path by turning a wheel");
  command
    ->add_option("WORLD", options.File,
      "WORLD.csv with columns s,value[,friction] [m of hand displacement, any unit, N], one position per row")
    ->required();
  command->add_option("--device", options.Device, "Device; its x axis is turned")->capture_default_str();
  command->add_option("--seconds", options.Seconds, "Duration [s]")->capture_default_str();
  command->add_option("--hardest", options.Hardest_N, "Force at the steepest slope of the value [N]")
    ->capture_default_str();
  command->add_option("--detent-every", options.DetentEvery_m, "Distance between detents [m]; 0: none");
  command->add_option("--detent", options.Detent_N, "Largest force of a detent [N]");
  command->add_option("--stop", options.Stop_N_per_m, "Stiffness of the stops at both ends [N/m]")
    ->capture_default_str();
  command->add_option("--csv", options.Output, "Output: OUT.csv with columns t,s,force, one row every 10 ms");
}

void CheckNumber(const char* option, double value, bool zeroAllowed, const char* unit)
{
  if (!std::isfinite(value) || value < 0.0 || (value == 0.0 && !zeroAllowed))
  {
    std::ostringstream message;
    message << option << ' ' << value << ": must be a finite number of " << unit
            << (zeroAllowed ? ", 0 or more" : ", more than 0");
    throw vtkHapticCliProblem(message.str());
  }
}

/// The default, 0, has a meaning of its own, and nobody gives it: a stiffness or a lever is above 0.
void CheckAboveZero(const vtkHapticCliSettings& settings, const char* setting, const char* unit)
{
  if (settings.IsGiven(setting))
  {
    CheckNumber(settings.OptionsOf(setting).c_str(), settings.Number(setting), false, unit);
  }
}

/// An option without effect is refused.
void CheckEffect(const char* option, bool given, bool there, const char* what)
{
  if (given && !there)
  {
    throw vtkHapticCliProblem(
      std::string(option) + " has no effect on these inputs; add " + what + ", give a mechanism, or omit " + option);
  }
}

int Touch(const vtkHapticCliTouchOptions& options)
{
  const vtkHapticCliSettings& settings = options.Settings;
  CheckAboveZero(settings, "MechanismTurning", "newton metres per radian");
  CheckAboveZero(settings, "ToolLever", "scene units");
  settings.Check();
  const bool mechanism = vtkHapticIsMechanismFile(options.Files.front());
  const bool loose = !options.Loose.empty();
  CheckEffect("--low-rate", settings.IsGiven("SoftRate"), options.Soft.Young_Pa || mechanism || loose, "--young");
  CheckEffect("--torque-stiffness", settings.IsGiven("MechanismTurning"), !options.Tool.empty() || mechanism, "--tool");
  return vtkHapticCliTouch(options);
}

int Check(const vtkHapticCliCheckOptions& options)
{
  CheckNumber("--thin", options.Thin_u, true, "scene units");
  CheckAboveZero(options.Settings, "MechanismTurning", "newton metres per radian");
  options.Settings.Check();
  const bool mechanism = vtkHapticIsMechanismFile(options.File);
  if (options.Settings.IsGiven("MechanismTurning") && !mechanism)
  {
    throw vtkHapticCliProblem("--torque-stiffness applies to mechanisms only; omit this option");
  }
  if (mechanism)
  {
    const std::string setting = options.Settings.GivenBeside({ "MechanismTurning" });
    const std::string asked = !setting.empty() ? setting : options.Iso ? "--iso" : options.Simplify ? "--simplify" : "";
    if (!asked.empty())
    {
      throw vtkHapticCliProblem(asked + " does not apply to a mechanism; omit this option");
    }
    return vtkHapticCliCheckMechanism(options);
  }
  return vtkHapticCliCheck(options);
}

int Labyrinth(const vtkHapticCliLabyrinthOptions& options)
{
  constexpr double slowest_Hz = 10.0, fastest_Hz = 1000.0;
  if (!(options.Host_Hz >= slowest_Hz && options.Host_Hz <= fastest_Hz))
  {
    throw vtkHapticCliProblem("--host: must be a rate from 10 to 1000 Hz");
  }
  if (options.Corridor_u)
  {
    CheckNumber("--corridor", *options.Corridor_u, false, "scene units");
  }
  return vtkHapticCliLabyrinth(options);
}

int Turn(const vtkHapticCliTurnOptions& options)
{
  CheckNumber("--seconds", options.Seconds, false, "seconds");
  CheckNumber("--hardest", options.Hardest_N, true, "newtons");
  CheckNumber("--detent-every", options.DetentEvery_m, true, "metres");
  CheckNumber("--detent", options.Detent_N, true, "newtons");
  CheckNumber("--stop", options.Stop_N_per_m, false, "newtons per metre");
  return vtkHapticCliTurn(options);
}

int Run(const CLI::App& app, const Arguments& arguments)
{
  if (app.got_subcommand("devices"))
  {
    const bool test = app.get_subcommand("devices")->count("--self-test") > 0;
    return test ? vtkHapticCliSelfTest(arguments.SelfTest, arguments.Keep, arguments.Wheel)
                : vtkHapticCliDevices(arguments.DevicesJson);
  }
  if (app.got_subcommand("check"))
  {
    return Check(arguments.Check);
  }
  if (app.got_subcommand("touch"))
  {
    return Touch(arguments.Touch);
  }
  if (app.got_subcommand("labyrinth"))
  {
    return Labyrinth(arguments.Labyrinth);
  }
  if (app.got_subcommand("replay"))
  {
    return vtkHapticCliReplay(arguments.Replay);
  }
  if (app.got_subcommand("turn"))
  {
    return Turn(arguments.Turn);
  }
  if (app.got_subcommand("arm"))
  {
    return vtkHapticCliArm(arguments.Arm, arguments.ArmJson);
  }
  throw vtkHapticCliProblem(
    "missing command: use devices, check, touch, turn, arm, replay or labyrinth (see palpate --help)");
}

int Refuse(std::string reason)
{
  std::replace_if(
    reason.begin(), reason.end(), [](unsigned char c) { return c < 0x20; }, ' ');
  std::cerr << "palpate: " << reason << '\n';
  return BadInput;
}
} // namespace

int main(int argc, char** argv)
{
  Arguments arguments;
  CLI::App app("Touch data without a display, with the same tick that drives a haptic device.", "palpate");
  app.set_version_flag("--version",
    std::string(PALPATE_VERSION "\nmade with " PALPATE_MADE_WITH ", runs with VTK ") + vtkVersion::GetVTKVersion());
  app.require_subcommand(0, 1); // a wrong name is reported as such, not as a missing one
  AddDevices(app, arguments);
  AddCheck(app, arguments);
  AddTouch(app, arguments);
  AddReplay(app, arguments);
  AddLabyrinth(app, arguments);
  AddTurn(app, arguments);
  AddArm(app, arguments);
  try
  {
    app.parse(argc, argv);
    return Run(app, arguments);
  }
  catch (const CLI::Success& helpOrVersion)
  {
    return app.exit(helpOrVersion);
  }
  catch (const CLI::ParseError& error)
  {
    return Refuse(std::string(error.what()) + " (see palpate --help)");
  }
  catch (const std::bad_alloc&)
  {
    return Refuse("not enough memory for these data; use fewer triangles, points or cells");
  }
  catch (const std::exception& error)
  {
    return Refuse(error.what());
  }
}
