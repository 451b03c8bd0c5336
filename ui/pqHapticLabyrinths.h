// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticLabyrinths_h
#define pqHapticLabyrinths_h

#include <QDialog>
#include <QPointer>

#include <optional>
#include <vector>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class pqDataRepresentation;
class pqPipelineSource;

/**
 * The labyrinth game: a world of the gallery or of one's own, start again, walls hidden so that it is explored by touch
 * alone, where the hand is and how long it took. Everything can be reached with the keyboard. The game ends with its
 * button, with the dialog and with its source; ball, scale and place are then as before.
 */
class pqHapticLabyrinths : public QDialog
{
  Q_OBJECT
  typedef QDialog Superclass;

public:
  explicit pqHapticLabyrinths(QWidget* parent);

private:
  void list();
  void chooseFile();
  void play();
  /// Fits the world anew, which undoes a zoom, and leads the hand to the start.
  void again();
  void end();
  void hideWalls(bool hidden);
  /// Requests by the buttons of the device.
  void grant(int wish);
  /// The path is shown from the exit on, unless somebody asks for it before.
  void followTrace();
  /// Enlarges the world about the hand until neighbouring corridors can be told apart.
  void zoom();
  void readOut();
  /// Gives the world to the source of the game in the pipeline, shown in the active view.
  void openWorld(const QString& world);
  /// Why the chosen world cannot be played, or nothing.
  QString refusal(const QString& world) const;
  /// Plays the labyrinth of the source. The settings for the game go to the session's proxy too, so that panel and
  /// state file say the same.
  void begin();
  void keepSettings();
  /// Another session has settings of its own.
  void forgetSettings();

  /// An element of a property that a game sets, and its previous value.
  struct Setting
  {
    const char* Name;
    unsigned int Element;
    double Value;
  };

  QListWidget* Worlds;
  QDoubleSpinBox* Corridor;
  QCheckBox* Hidden;
  QCheckBox* Trace;
  QLabel* State;
  QLabel* Time;
  QLabel* Place;
  QLabel* Message;
  QPointer<pqPipelineSource> Source;
  QPointer<pqDataRepresentation> Shown;
  std::vector<Setting> Before;   ///< empty while nothing is played
  std::optional<double> Opacity; ///< of walls that are hidden now, as it was
  bool Finished = false;         ///< the exit was reached
  bool Showed = false;           ///< the trace, because of that
};

#endif
