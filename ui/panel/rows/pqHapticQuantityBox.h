// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticQuantityBox_h
#define pqHapticQuantityBox_h

#include <QDoubleSpinBox>

/**
 * A number of any size: scenes are in nanometres and in kilometres.
 *
 * Shown with nine significant digits, with a power of ten where that is shorter; a step changes its second digit.
 */
class pqHapticQuantityBox : public QDoubleSpinBox
{
  Q_OBJECT
  typedef QDoubleSpinBox Superclass;

public:
  explicit pqHapticQuantityBox(QWidget* parent = nullptr);
  ~pqHapticQuantityBox() override;

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;
  void stepBy(int steps) override;

private:
  QString numberIn(const QString& text) const;
};

#endif
