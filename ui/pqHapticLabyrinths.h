// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticLabyrinths_h
#define pqHapticLabyrinths_h

#include <QDialog>
#include <QPointer>

class QCheckBox;
class QLabel;
class QListWidget;
class pqDataRepresentation;
class pqPipelineSource;

/**
 * The game of finding the way: a world of the gallery or of one's own, start again, walls hidden so that it is explored
 * by touch alone, where the hand is and how long it took. Everything can be reached with the keyboard.
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
  void again();
  void hideWalls(bool hidden);
  /// What the buttons of the device asked for.
  void grant(int wish);
  /// The way is shown from the exit on, unless somebody asks for it before.
  void followTrace();
  /// Enlarges the world about the hand until neighbouring corridors can be told apart.
  void zoom();
  void readOut();
  /// The chosen world as a source in the pipeline, shown in the active view; null with a message if it is none.
  pqPipelineSource* open(const QString& world);
  /// What the session set for the game, in its proxy too, so that panel and state file say the same.
  void tellProxy();

  QListWidget* Worlds;
  QCheckBox* Hidden;
  QCheckBox* Trace;
  QLabel* State;
  QLabel* Time;
  QLabel* Place;
  QLabel* Message;
  QPointer<pqPipelineSource> Source;
  QPointer<pqDataRepresentation> Shown;
  bool Finished = false; ///< the exit was reached
};

#endif
