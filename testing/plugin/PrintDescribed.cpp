// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of settings and read-outs as JSON, for described.py.
#include <iostream>

#include "haptics/session/settings/SessionSettings.h"

int main()
{
  std::cout << palpate::describedAsJson() << '\n';
  return 0;
}
