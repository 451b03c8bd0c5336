// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticLabyrinthGame
 * @brief   the labyrinth game of a session, between lines
 */
#ifndef vtkHapticLabyrinthGame_h
#define vtkHapticLabyrinthGame_h

#include "vtkHapticSessionPart.h"

class vtkDataObject;
class vtkPolyData;

class VTKHAPTICINTERACTION_EXPORT vtkHapticLabyrinthGame : public vtkHapticSessionPart
{
public:
  vtkAbstractTypeMacro(vtkHapticLabyrinthGame, vtkHapticSessionPart);
  static vtkSmartPointer<vtkHapticLabyrinthGame> Of(vtkHapticSession& session);

  /// The labyrinth game between lines with the field arrays Start and Exit (vtkHapticLabyrinth): it sets ball, scale
  /// and place so that the device's workspace holds the whole. Once force is engaged the hand is brought to the start,
  /// at most 0.2 m/s fast, and let go; at the exit it is shaken. Who lets go of the dead-man and holds it again starts
  /// anew, as does PlayAgain(). The lines are added as one surface. A world without start or exit is fitted too and
  /// explored without a game: false, and the session's GetProblem() says which it lacks. False with an error and
  /// nothing changed for data that are no plane world.
  bool Play(vtkDataObject* maze, const char* name);

  ///@{
  /// Phases: "off", "waits", "leads", "lets go", "explores", "arrived" or "rests", as text in words for the person;
  /// time of exploring [s]; where the labyrinth that was played last begins and ends, in W, and how near counts as
  /// there [u].
  void PlayAgain();
  void End();
  bool GetPlayed() const;
  const char* GetPhase() const;
  const char* GetText() const;
  double GetTime() const;
  void GetPlaces(double start_W[3], double exit_W[3]) const;
  double GetReach() const;
  /// By how much that labyrinth must be enlarged for neighbouring corridors to be told apart [1], at least 1, infinite
  /// without stiffness; the narrowest corridor that can be: 2 F / K [m of the hand], F = 1 N.
  double GetFeelableZoom() const;
  double GetFeelableWidth() const;
  /// The path of the proxy since it was let go, until now or the exit: a polyline in W [u], as the calls of the
  /// session's Update() saw it. At most 4096 points, a tenth of a corridor apart; twice as far each time that is not
  /// enough.
  void GetTrace(vtkPolyData* trace) const;
  /// Which labyrinth the device's buttons asked for since the last call, while no game is played: button n for number
  /// n, a button of the dead-man for none; 0: none.
  int TakeWish();
  ///@}

private:
  explicit vtkHapticLabyrinthGame(vtkHapticSession& session) : vtkHapticSessionPart(session) {}
};

#endif
