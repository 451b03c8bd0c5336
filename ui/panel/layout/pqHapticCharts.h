// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticCharts_h
#define pqHapticCharts_h

#include <QStringList>
#include <QWidget>

class QVBoxLayout;
class pqHapticStrip;
class vtkHapticSession;

/// Strip charts of the last ten seconds of a touch. After the touch they say that their values are the last ones. The
/// next touch begins the charts anew, and so does another scene: other surfaces or another field are felt.
class pqHapticCharts : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  explicit pqHapticCharts(QWidget* parent = nullptr);
  ~pqHapticCharts() override;

  /// Null where there is no session; `report`: pqHapticViewFollower::report(). Ten times a second.
  void refresh(vtkHapticSession* session, const QString& report);
  /// Another session: nothing was measured.
  void clear();

private:
  pqHapticStrip* add(QVBoxLayout* column, const char* name, const QString& title, const char* unit, const QString& tip);

  pqHapticStrip* Force;
  pqHapticStrip* Depth;
  pqHapticStrip* Lateness;
  pqHapticStrip* Energy;
  bool Touched = false; ///< at the last look
  QStringList Scene;    ///< names of the felt sources at the last look
};

#endif
