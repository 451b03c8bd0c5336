// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticMeasuring_h
#define pqHapticMeasuring_h

#include <QObject>

class pqHapticController;
class pqPipelineSource;

/// Filters that measure, in the client: a new Map Around Contact begins at the last contact, and ParaView's status bar
/// says results. A result is the property Text of a filter whose hints have StatusBar, after each update of its data.
/// ParaView's Properties panel leaves out properties that are results.
class pqHapticMeasuring : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticMeasuring(pqHapticController* controller);

private:
  void beginAtContact(pqPipelineSource* source) const;
  void say(pqPipelineSource* source) const;

  pqHapticController* Controller;
};

#endif
