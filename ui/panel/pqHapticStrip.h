// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticStrip_h
#define pqHapticStrip_h

#include <QString>
#include <QWidget>

#include <deque>

/**
 * A live strip chart: one quantity over the last ten seconds, with its value now and its scale.
 *
 * The scale goes from 0 (or the least value, if that is below) to the largest of the last ten seconds, never to less
 * than the smallest scale that says something. It is drawn in the colours of the palette, so it follows light and dark.
 */
class pqHapticStrip : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  /// `least`: the smallest scale, in `unit`.
  pqHapticStrip(QWidget* parent, const char* name, const QString& title, const QString& unit, double least);
  ~pqHapticStrip() override;

  /// The value now; called ten times a second.
  void add(double value);
  /// Nothing is measured any more.
  void clear();

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  /// Title and value now, for the eye and for a reader of screens.
  QString sentence() const;

  QString Title;
  QString Unit;
  double Least;
  std::deque<double> Values;
  bool Painted = false; ///< the last value
};

#endif
