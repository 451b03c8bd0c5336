// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <sstream>
#include <utility>

#include "haptics/session/settings/SessionSettings.h"
#include "vtkHapticCliCommands.h"
#include "vtkHapticCliMaterials.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticMechanismFile.h"

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
};

void AddDevices(CLI::App& app, Arguments& arguments)
{
  CLI::App* command = app.add_subcommand("devices", "what is attached, what each can do, why one cannot be used");
  CLI::Option* json = command->add_flag("--json", arguments.DevicesJson, "for a program to read");
  CLI::Option* test = command->add_option("--self-test", arguments.SelfTest,
    "ID: check that device with the person who holds it; a simulated hand does what is asked");
  test->excludes(json);
  command->add_flag("--keep", arguments.Keep, "what the check found, to be applied from now on")->needs(test);
  command->add_flag("--wheel", arguments.Wheel, std::string(palpate::sessionSetting("Wheel").sentence))->needs(test);
}

void AddCheck(CLI::App& app, Arguments& arguments)
{
  vtkHapticCliCheckOptions& options = arguments.Check;
  CLI::App* command = app.add_subcommand("check", "can it be touched? what was repaired, what is refused");
  command
    ->add_option("FILE", options.File,
      "vtp, vtu, stl, ply, obj, off; vti, nii, nii.gz with --iso; lines: vtp, svg, png; mechanisms: json")
    ->required();
  command->add_option("--iso", options.Iso, "value of the surface in an image");
  options.Settings.Add(*command, "Radius", "does it fit?");
  command->add_flag("--force-radius", options.ForceRadius, "that ball, although a tick may run out of its work");
  options.Settings.Add(*command, "LineRadius", "at 0 walls across the plane z = 0");
  options.Settings.Add(*command, "FrictionStatic");
  options.Settings.Add(*command, "FrictionKinetic", "without it the static one");
  vtkHapticCliAddMaterials(*command, options.Materials);
  command->add_option("--thin", options.Thin_u, "name walls of a closed surface that are thinner [scene units]")
    ->check(CLI::NonNegativeNumber);
  command->add_option("--torque-stiffness", options.Turning_N_m_per_rad,
    "of the hand that holds a mechanism, whose turn is free without it [N m/rad]");
  command->add_flag("--simplify", options.Simplify, "with how few triangles it would feel the same, proven");
  command->add_flag("--json", options.Json, "for a program to read");
}

void AddTouch(CLI::App& app, Arguments& arguments)
{
  vtkHapticCliTouchOptions& options = arguments.Touch;
  CLI::App* command = app.add_subcommand("touch", "the tick along a given device path, without device limits");
  command
    ->add_option("FILE", options.Files,
      "surfaces; images with --iso; lines (vtp, svg, png) with --two-d or --line-radius; a mechanism (json)")
    ->required();
  command->add_option("--path", options.Path, "PATH.csv: t,x,y,z[,qw,qx,qy,qz] [s, scene units], a tick per row")
    ->required();
  command->add_option("--csv", options.Output, "OUT.csv: a row per tick")->required();
  command->add_option("--iso,--value", options.Iso, "value of the surface in an image, or of --mode isosurface");
  options.Settings.AddAll(*command);
  vtkHapticCliAddMaterials(*command, options.Materials);
  vtkHapticCliAddField(*command, options.Field);
  CLI::Option* tool =
    command->add_option("--tool", options.Tool.File, "mesh in the hand that turns; its origin is held");
  CLI::Option* lever = command->add_option(
    "--lever", options.Tool.Lever_u, "of --tool: what a turn by 1 rad weighs as a way [u]; else that of the mesh");
  command
    ->add_option("--torque-stiffness", options.Turning_N_m_per_rad,
      "of --tool, in place of --lever, or of a mechanism, whose turn is free without it [N m/rad]")
    ->excludes(lever);
  lever->needs(tool);
  command
    ->add_flag(
      "--virtual-coupling", options.Tool.VirtualCoupling, "of --tool: a spring to the hand, not what contacts push")
    ->needs(tool);
  CLI::Option* young = command->add_option("--young", options.Soft.Young_Pa,
    "FILE is a body that gives way, vtu or closed surface: its Young's modulus, 10 to below 1e12 [Pa]; a unit is "
    "1 / --scale metres");
  command->add_option("--poisson", options.Soft.Poisson, "of --young: Poisson's ratio, 0 to below 0.5")
    ->capture_default_str()
    ->needs(young);
  command
    ->add_option("--fixed", options.Soft.Fixed,
      "of --young: what is held, sides of its box (xmin,xmax,ymin,ymax,zmin,zmax) or a point array")
    ->needs(young);
  command->add_option("--model", options.Soft.Model, "of --young: linear, corotational or neohookean")
    ->capture_default_str()
    ->check(CLI::IsMember({ "linear", "corotational", "neohookean" }))
    ->needs(young);
  command->add_option("--low-rate", options.Soft.AskedRate_Hz,
    "of --young or a mechanism: how often a body is computed [Hz], virtual time, 30 without; 0: at rest in every tick");
  command->add_flag("--two-d", options.TwoD, "lines in the plane z = 0 are walls, felt in that plane");
}

void AddReplay(CLI::App& app, Arguments& arguments)
{
  vtkHapticCliReplayOptions& options = arguments.Replay;
  CLI::App* command = app.add_subcommand("replay", "recompute a recording and compare bit for bit");
  command->add_option("RECORDING", options.Recording, "as a session saved it")->required();
  command->add_option("--scene", options.Scenes, "surfaces, for a recording that holds no scenes");
  command->add_option("--iso", options.Iso, "value of the surface in an image");
  command->add_option("--csv", options.Output, "OUT.csv: a row per tick, as recomputed");
}

void AddLabyrinth(CLI::App& app, Arguments& arguments)
{
  vtkHapticCliLabyrinthOptions& options = arguments.Labyrinth;
  CLI::App* command = app.add_subcommand("labyrinth", "a plane world: what it is, and a hand's way through it");
  command->add_option(
    "FILE", options.File, "lines in the plane z = 0, or a name of the gallery; without: all of these");
  CLI::Option* solve = command->add_flag("--solve", options.Solve, "a blind hand finds the exit, by touch alone");
  command->add_option("--path", options.Path, "PATH.csv: t,x,y,z of a hand [s, scene units], a tick per row")
    ->excludes(solve);
  command->add_option("--csv", options.Output, "TRACE.csv of the way");
  command->add_option("--corridor", options.Corridor_u, "width of its corridors [scene units]");
  CLI::Option* play = command->add_flag("--play", options.Play,
    "from the device alone: button n plays labyrinth n (FILE, or each of the gallery), the next one ends");
  play->excludes(solve)->excludes("--path");
  command->add_option("--hold", options.Hold,
    "with --play, what must be held: the number of a button, or grip; without: the button that chose");
  command->add_option("--device", options.Device,
    "of the blind hand: simulated-joystick without; with --play: the one plugged in without");
  command->add_option("--host", options.Host_Hz, "updates of the host [Hz]")->capture_default_str();
  command->add_flag("--device-walls", options.DeviceWalls, "the device holds the walls in its own loop");
}

void AddTurn(CLI::App& app, Arguments& arguments)
{
  vtkHapticCliTurnOptions& options = arguments.Turn;
  CLI::App* command = app.add_subcommand("turn", "a value along a path, felt by turning a wheel");
  command->add_option("WORLD", options.File, "WORLD.csv: s,value[,friction] [m of the hand, any, N], a place per row")
    ->required();
  command->add_option("--device", options.Device, "what is turned: its x")->capture_default_str();
  command->add_option("--seconds", options.Seconds, "for how long")->capture_default_str();
  command->add_option("--hardest", options.Hardest_N, "with what the steepest slope of the value draws [N]")
    ->capture_default_str();
  command->add_option("--detent-every", options.DetentEvery_m, "from one detent to the next [m]; 0: none");
  command->add_option("--detent", options.Detent_N, "largest force of a detent [N]");
  command->add_option("--stop", options.Stop_N_per_m, "stiffness of the stops at both ends [N/m]")
    ->capture_default_str();
  command->add_option("--csv", options.Output, "OUT.csv: t,s,force every 10 ms");
}

void CheckNumber(const char* option, double value, bool zeroAllowed, const char* unit)
{
  if (!std::isfinite(value) || value < 0.0 || (value == 0.0 && !zeroAllowed))
  {
    std::ostringstream message;
    message << option << ' ' << value << ": it has to be a finite number of " << unit
            << (zeroAllowed ? ", 0 or more" : ", more than 0");
    throw vtkHapticCliProblem(message.str());
  }
}

/// A turn that is free has no stiffness: nobody gives one of 0.
void CheckTurning(const std::optional<double>& turning_N_m_per_rad)
{
  if (turning_N_m_per_rad)
  {
    CheckNumber("--torque-stiffness", *turning_N_m_per_rad, false, "newton metres per radian");
  }
}

/// An option of something that is not there would be lost.
void CheckWhatHasIt(const char* option, bool given, bool there, const char* what)
{
  if (given && !there)
  {
    throw vtkHapticCliProblem(
      std::string(option) + ": there is nothing that has it; add " + what + ", give a mechanism, or leave it out");
  }
}

/// What has no meaning among lines without width is refused rather than ignored.
void CheckTwoD(const vtkHapticCliTouchOptions& options)
{
  const std::array<std::pair<const char*, bool>, 5> others = { { { "--iso", options.Iso.has_value() },
    { "--line-radius", options.Settings.Number("LineRadius") != 0.0 }, { "--field", options.Field.Any() },
    { "--shading", options.Settings.Number("ForceShading") != 0.0 },
    { "arrays of materials", !options.Materials.Empty() } } };
  for (const auto& [name, given] : others)
  {
    if (given)
    {
      throw vtkHapticCliProblem(
        std::string("--two-d feels lines as they are, without ") + name + "; leave out one of both");
    }
  }
}

int Touch(const vtkHapticCliTouchOptions& options)
{
  if (options.TwoD)
  {
    CheckTwoD(options);
  }
  CheckTurning(options.Turning_N_m_per_rad);
  CheckNumber("--low-rate", options.Soft.LowRate_Hz(), true, "hertz");
  options.Settings.Check();
  vtkHapticCliCheckMaterials(options.Materials);
  const bool mechanism = vtkHapticIsMechanismFile(options.Files.front());
  CheckWhatHasIt("--low-rate", options.Soft.AskedRate_Hz.has_value(), options.Soft.Young_Pa || mechanism, "--young");
  CheckWhatHasIt(
    "--torque-stiffness", options.Turning_N_m_per_rad.has_value(), !options.Tool.File.empty() || mechanism, "--tool");
  return mechanism ? vtkHapticCliTouchMechanism(options) : vtkHapticCliTouch(options);
}

int Check(const vtkHapticCliCheckOptions& options)
{
  CheckNumber("--thin", options.Thin_u, true, "scene units");
  CheckTurning(options.Turning_N_m_per_rad);
  options.Settings.Check();
  vtkHapticCliCheckMaterials(options.Materials);
  const bool mechanism = vtkHapticIsMechanismFile(options.File);
  if (options.Turning_N_m_per_rad && !mechanism)
  {
    throw vtkHapticCliProblem("--torque-stiffness: only a mechanism is turned here; leave it out");
  }
  if (mechanism)
  {
    const std::string setting = options.Settings.GivenBeside({});
    const std::string asked = !setting.empty()             ? setting
                              : options.Iso                ? "--iso"
                              : options.Simplify           ? "--simplify"
                              : !options.Materials.Empty() ? "an array of the material"
                                                           : "";
    if (!asked.empty())
    {
      throw vtkHapticCliProblem(asked + ": a mechanism does not have it; leave it out");
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
    throw vtkHapticCliProblem("--host: a rate from 10 to 1000 Hz");
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
  throw vtkHapticCliProblem(
    "say what to do: devices, check, touch, turn, replay or labyrinth (palpate --help says more)");
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
  CLI::App app("Touches surfaces without a display: the same tick that drives a haptic device.", "palpate");
  app.set_version_flag("--version", PALPATE_VERSION);
  app.require_subcommand(0, 1); // a wrong name is reported as such, not as a missing one
  AddDevices(app, arguments);
  AddCheck(app, arguments);
  AddTouch(app, arguments);
  AddReplay(app, arguments);
  AddLabyrinth(app, arguments);
  AddTurn(app, arguments);
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
    return Refuse(std::string(error.what()) + " (palpate --help says what can be asked)");
  }
  catch (const std::bad_alloc&)
  {
    return Refuse("there is not enough memory for this");
  }
  catch (const std::exception& error)
  {
    return Refuse(error.what());
  }
}
