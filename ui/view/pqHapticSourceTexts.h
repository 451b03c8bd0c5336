// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticSourceTexts_h
#define pqHapticSourceTexts_h

#include <QObject>

class pqPipelineSource;

/// ParaView's status bar says results of filters: after each update of its data the property Text of a filter whose
/// hints have StatusBar. ParaView's Properties panel leaves out properties that are results.
class pqHapticSourceTexts : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticSourceTexts(QObject* parent);

private:
  void say(pqPipelineSource* source) const;
};

#endif
