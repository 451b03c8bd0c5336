// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliCommands_h
#define vtkHapticCliCommands_h

#include <optional>
#include <string>
#include <vector>

#include "haptics/labyrinth/Labyrinth.h"

#include "vtkHapticCliField.h"
#include "vtkHapticCliSettings.h"

/// The commands of the program `palpate`. Each returns the exit code and throws vtkHapticCliProblem for bad input.

/// Lists the attached devices, their abilities, and why one cannot be used.
int vtkHapticCliDevices(bool json);

/// Checks a device with the person who holds it, who may say that it is a wheel, and keeps the result if `keep`. 0: it
/// passed, 1: it did not.
int vtkHapticCliSelfTest(const std::string& device, bool keep, bool wheel);

/// Prints forces and masses of an arm, of that file or that name, in its work space. 0: it can be used; a fault throws.
int vtkHapticCliArm(const std::string& file, bool json);

struct vtkHapticCliTurnOptions
{
  std::string File;
  std::string Device = "simulated-joystick";
  std::string Output; ///< empty: none
  double Seconds = 10.0;
  double Hardest_N = 0.3; ///< the steepest slope of the value draws with it
  double DetentEvery_m = 0.0;
  double Detent_N = 0.0;
  double Stop_N_per_m = 100.0;
};

/// A value along a path, with detents, friction and stops, felt by turning a wheel. 0: it was felt as long as asked
/// for.
int vtkHapticCliTurn(const vtkHapticCliTurnOptions& options);

struct vtkHapticCliCheckOptions
{
  std::string File;
  std::optional<double> Iso;
  bool Simplify = false;         ///< also with how few triangles it would feel the same, which takes a while
  bool ForceRadius = false;      ///< a ball as large as asked for, although a tick may run out of its work
  double Thin_u = 0.0;           ///< walls below that are named; 0: none is looked for
  vtkHapticCliSettings Settings; ///< with a LineRadius of 0 lines are walls
  bool Json = false;
};

/// Whether a file can be touched, with repairs, refusals, and the choices of a session for it. 0: touchable; a refusal
/// throws.
int vtkHapticCliCheck(const vtkHapticCliCheckOptions& options);

/// The plan of a mechanism of a scene file. 0: it can be felt; a fault throws.
int vtkHapticCliCheckMechanism(const vtkHapticCliCheckOptions& options);

/// A soft body: the first file.
struct vtkHapticCliSoftOptions
{
  std::optional<double> Young_Pa; ///< none: nothing is soft
  double Poisson = 0.4;
  std::string Fixed; ///< sides of its box, or a point array
  std::string Model = "linear";
};

struct vtkHapticCliTouchOptions
{
  std::vector<std::string> Files;
  std::string Path;
  std::string Output;
  std::optional<double> Iso;
  bool TwoD = false; ///< lines in the plane z = 0, felt by a disc
  vtkHapticCliFieldOptions Field;
  std::string Loose;            ///< a loose body; empty: none
  double Density = 0.0;         ///< of that [kg/m3]
  std::string Tool;             ///< a mesh in the hand, whose frame's origin is in the hand; empty: a ball touches
  bool VirtualCoupling = false; ///< of the tool: a spring to the hand, in place of the push of the contacts
  vtkHapticCliSoftOptions Soft;
  vtkHapticCliSettings Settings;
};

/// The filter Touch Along Path for files: one row of Path, one tick, one row of Output.
int vtkHapticCliTouch(const vtkHapticCliTouchOptions& options);

struct vtkHapticCliReplayOptions
{
  std::string Recording;
  std::vector<std::string> Scenes; ///< for a recording that holds none
  std::optional<double> Iso;       ///< for the images among them
  std::string Output;              ///< empty: none
};

/// Recomputes a recording. 0: the same bit for bit; 1: the first difference was printed.
int vtkHapticCliReplay(const vtkHapticCliReplayOptions& options);

struct vtkHapticCliLabyrinthOptions
{
  std::string File;   ///< or the name of a world of the gallery; empty: list them
  std::string Device; ///< empty: simulated-joystick, or with Play the one that is plugged in
  double Host_Hz = 1000.0;
  bool DeviceWalls = false;
  bool Solve = false;
  bool Play = false;
  std::string Hold;                 ///< a button or "grip", to be held while a game goes on; empty: the button that
                                    ///< chose it
  std::optional<double> Corridor_u; ///< else the file's, or 1
  std::string Path;                 ///< of a hand, in place of a blind one
  std::string Output;               ///< trace; empty: none
};

/// A plane world: its description, or a hand's path through it, blind or along a given path. 0: described or arrived;
/// 1: not arrived.
int vtkHapticCliLabyrinth(const vtkHapticCliLabyrinthOptions& options);

/// These labyrinths, played from a device alone until its buttons or an interrupt end it. 0: somebody arrived; 1:
/// nobody.
int vtkHapticCliPlay(std::vector<palpate::Labyrinth> labyrinths, const vtkHapticCliLabyrinthOptions& options);

#endif
