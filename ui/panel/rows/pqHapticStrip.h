// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticStrip_h
#define pqHapticStrip_h

#include <QString>
#include <QWidget>

#include <deque>

/**
 * A live strip chart: one quantity over the last ten seconds, or against another one in that time, with its value now
 * or last, and its scale. Values are rounded to a hundredth of the smallest scale.
 *
 * The scale goes from 0 (or the least value, if that is below) to the largest of the last ten seconds, never to less
 * than the smallest scale that says something. The chart is drawn in the colours of the palette, so it follows light
 * and dark.
 */
class pqHapticStrip : public QWidget
{
  Q_OBJECT
  Q_PROPERTY(QString scale READ scale)
  typedef QWidget Superclass;

public:
  /// `least`: the smallest scale, in `unit`.
  pqHapticStrip(QWidget* parent, const char* name, const QString& title, const QString& unit, double least);
  ~pqHapticStrip() override;

  /// The value now; called ten times a second.
  void add(double value);
  /// Likewise against another quantity, in its own unit: a strip has values of one sort alone.
  void addAt(double value, double along);
  /// Nothing is measured any more: the last values stay, and are said to be the last.
  void setLast();
  /// Nothing was measured.
  void clear();

  /// Upper end of the scale with its unit, as it is drawn.
  QString scale() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  /// Title and value now, for the eye and for a reader of screens.
  QString sentence() const;
  double high() const;
  double low() const;
  /// From the left of the strip to its right, 0 to 1.
  double across(std::size_t value) const;

  QString Title;
  QString Unit;
  double Least;
  std::deque<double> Values;
  std::deque<double> Along; ///< of each; empty: they are against time
  bool Painted = false;     ///< the last value
  bool Over = false;        ///< the last value is not the one now
};

#endif
