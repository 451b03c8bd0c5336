// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/Ticking.h"

#include <chrono>
#include <thread>

namespace palpate::test
{

using std::chrono::milliseconds;
using std::chrono::steady_clock;

bool waitUntil(const std::function<bool()>& done, int patience_ms)
{
  const auto until = steady_clock::now() + milliseconds(patience_ms);
  while (!done())
  {
    if (steady_clock::now() > until)
    {
      return false;
    }
    std::this_thread::sleep_for(milliseconds(1));
  }
  return true;
}

void Ticking::run(int duration_ms)
{
  static_cast<void>(this->runUntil([] { return false; }, duration_ms));
}

bool Ticking::runUntil(const std::function<bool()>& done, int patience_ms)
{
  return waitUntil(
    [&]
    {
      this->tick();
      return done();
    },
    patience_ms);
}

void Ticking::tick()
{
  this->status = this->ticked_.read(0.0, this->sample);
  this->ticked_.write(this->command);
}

} // namespace palpate::test
