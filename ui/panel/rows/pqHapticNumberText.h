// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticNumberText_h
#define pqHapticNumberText_h

#include <QString>

/// A number rounded to so many decimals, without zeros at its end and never as "-0": "30", "0.4".
inline QString pqHapticNumberText(double value, int decimals)
{
  QString text = QString::number(value, 'f', decimals);
  if (text.contains('.'))
  {
    while (text.endsWith('0'))
    {
      text.chop(1);
    }
    text.chop(text.endsWith('.') ? 1 : 0);
  }
  return text == "-0" ? QString("0") : text;
}

#endif
