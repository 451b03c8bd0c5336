// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticQuantityBox_h
#define pqHapticQuantityBox_h

#include <QDoubleSpinBox>

/**
 * A number without zeros at its end. Either of any size, as scenes are in nanometres and in kilometres: with nine
 * significant digits and a power of ten where that is shorter, and a step changes its second digit; or with so many
 * decimals.
 */
class pqHapticQuantityBox : public QDoubleSpinBox
{
  Q_OBJECT
  typedef QDoubleSpinBox Superclass;

public:
  explicit pqHapticQuantityBox(QWidget* parent = nullptr);
  pqHapticQuantityBox(int decimals, QWidget* parent);
  ~pqHapticQuantityBox() override;

  /// Whether the number is found by the session, and the box says so instead; a number that is typed is shown.
  void setAutomatic(bool on);

  /// A person reads and types so many times the value.
  void setFactor(double factor) { this->Factor = factor; }

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;
  void stepBy(int steps) override;

private:
  bool isSpecial(const QString& text) const;
  QString numberIn(const QString& text) const;

  bool Automatic = false;
  double Factor = 1.0;
};

#endif
