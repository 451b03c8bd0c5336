// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticEventPlayer_h
#define pqHapticEventPlayer_h

#include "pqHapticLayoutChecks.h"
#include "pqWidgetEventPlayer.h"

#include <QUrl>

class pqHapticController;

/**
 * Test events of our own, so that a script can move the hand, and wait without blocking the event loop:
 *
 *   hapticPose "x,y,z"               where the fed device holds the hand, in scene coordinates [u]
 *   hapticVirtualTime "1"            from the next touch on, only hapticMove and hapticStep make the servo tick
 *   hapticMove "x,y,z,n"             n ticks of virtual time in which the hand goes evenly to a point [u]
 *   hapticGlide "x,y,x,y,n"          the pointer goes over a widget in n moves; shares of its width and height
 *   hapticStep "n"                   n ticks of virtual time, then time for the panel to show them
 *   hapticTrace ""                   begins a Python trace; hapticTraced "words": ends it, and it has these
 *   hapticPythonState "words"        the Python state has these
 *   hapticPython "statement"         run by the client's own interpreter; fails if the statement raises
 *   hapticUndo "n"                   n steps back, or forward for n < 0, as far as there are any
 *   hapticUndoStep "name"            fails unless the next step back has this name
 *   hapticDevice "name"              chosen as a script does it
 *   hapticProperty "source,name,number"  set and applied; hapticShow "source,0|1": its eye
 *   hapticCamera "least,largest"     distance of the camera from its focal point [u]
 *   hapticHas "words"                in a label that is enabled, a table or the status bar of a window
 *   hapticWaitHas "ms,words"         processes events until hapticHas would pass, at most that long
 *   hapticWindow "width,height"      size of the main window [pixels]: there is no window manager
 *   hapticWait "ms"                  processes events for that long
 *   hapticWaitUntilReleased "ms"     processes events until nothing is touched any more, at most that long
 *   hapticStroke "x,y,z"             one more point of the path a simulated hand is led along, scene frame [u]
 *   hapticCheck "name,low,high"      fails unless it lies in [low, high]
 *   hapticWaitFor "name,low,high,ms" processes events until hapticCheck would pass, at most that long
 *   hapticTabOrder "name,name,..."   fails unless Tab goes through these fields of the object in this order
 *   hapticMnemonics ""               fails unless all that can be edited in the object has a mnemonic of its own
 *   hapticPlaces ""                  remembers where the widgets of the object are
 *   hapticStill ""                   fails if one of them has moved since, or is gone
 *   hapticSeen "whole|across"        fails if one is cut off, or is cut off at a side
 *   hapticExplains "name,name,..."   terms of the glossary that stand in titles of the object, whose tips define them
 *   hapticTip "words"                in the tip that a pointer which rests on the widget brings up
 *   hapticText "contrast,ratio"      pqHapticHasReadableText(); hapticDark "": all windows are light on dark
 *   hapticWatchFiles ""              from now on, files for other programs (a browser) are noted and not opened
 *   hapticOpened "page.html#anchor"  the noted file leads there; the page exists, beside the file, and has the anchor
 *   hapticAnotherSession ""          registers one as a script does; fails if the one before still touches or checks
 *
 * Names: force [N], depth [u], contacts, ticks, missed, largestStiffness [N/m], delay [ticks], velocityMethod; 0 or 1:
 * limitStiffness, passivity, clutch, precision and arrived (at the exit of a labyrinth).
 *
 * Q_OBJECT is required: ParaView keys players by class name.
 */
class pqHapticEventPlayer : public pqWidgetEventPlayer
{
  Q_OBJECT
  typedef pqWidgetEventPlayer Superclass;

public:
  explicit pqHapticEventPlayer(pqHapticController* controller, QObject* parent = nullptr);

  using Superclass::playEvent;
  bool playEvent(QObject* object, const QString& command, const QString& arguments, bool& failed) override;

private Q_SLOTS:
  void keepUrl(const QUrl& url);

private:
  bool opened(const QString& target) const;
  bool watchFiles();
  bool pose(const QStringList& numbers);
  bool move(const QStringList& arguments);
  bool addStrokePoint(const QStringList& numbers);
  bool glide(QWidget* widget, const QStringList& arguments);
  bool step(int ticks);
  bool resizeWindow(const QStringList& size);
  bool chooseDevice(const QString& name);
  bool checkScript(const std::string& script, const QString& part) const;
  bool runPython(const QString& statement) const;
  bool undo(int steps) const;
  bool setProperty(const QStringList& arguments);
  bool show(const QStringList& arguments);
  bool checkCamera(const QStringList& range) const;
  bool waitForText(QObject* object, const QString& arguments);
  bool setVirtualTime(bool on);
  bool wait(int time_ms);
  bool waitUntilReleased(int limit_ms);
  bool waitFor(const QStringList& arguments);
  bool holds(const QStringList& range) const;
  bool check(const QStringList& range);
  bool replaceSession();

  pqHapticController* Controller;
  QUrl Opened; ///< the last file that was to be opened by another program
  pqHapticPlaces Places;
  double Hand_W[3] = { 0.0, 0.0, 0.0 }; ///< where the script put it last [u]
};

#endif
