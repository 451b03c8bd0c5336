// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticLines_h
#define pqHapticLines_h

#include <QLabel>
#include <QString>
#include <QStringList>

/**
 * A text that always takes the space of so many lines, so that nothing below it moves when the text changes.
 *
 * A longer text ends in an ellipsis; the tip, the accessible description and *Copy* in the context menu have all of it.
 */
class pqHapticLines : public QLabel
{
  Q_OBJECT
  typedef QLabel Superclass;

public:
  pqHapticLines(QWidget* parent, const char* name, const QString& tip, int lines);
  ~pqHapticLines() override;

  /// Lengths in u are shown in the unit of the scene.
  void say(const QString& said);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  /// The lines as they are shown, and whether that is the whole text.
  QStringList shown(bool& whole) const;
  void describe();

  QString Tip;
  int Lines;
};

#endif
