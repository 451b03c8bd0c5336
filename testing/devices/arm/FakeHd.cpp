// SPDX-License-Identifier: GPL-3.0-or-later
// A library with the names of OpenHaptics', whose scheduler calls back from a thread of its own.
#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>

namespace
{

using Callback = std::uint32_t (*)(void*);

struct Error
{
  std::uint32_t code;
  int internal;
  std::uint32_t device;
};

std::atomic<double> force[3], lastPush[3]; // lastPush: the last force that was one
std::atomic<double> place_mm[3] = { 10.0, 20.0, -30.0 }, speed_mm_per_s = 100.0, turned = 1.0;
std::atomic<std::uint32_t> failure = 0;
std::atomic<int> rate_Hz = 1000, outputOn = 0, calls = 0, pushes = 0, opened = 0;
std::atomic<bool> runs = false, holds = false, isHeld = false;
Callback callback = nullptr;
void* data = nullptr;
std::thread scheduler;

} // namespace

extern "C"
{
  std::uint32_t hdInitDevice(const char*)
  {
    ++opened;
    return 5;
  }
  void hdDisableDevice(std::uint32_t)
  {
    --opened;
    outputOn = 0;
    force[0] = force[1] = force[2] = 0.0;
  }
  void hdMakeCurrentDevice(std::uint32_t) {}
  void hdBeginFrame(std::uint32_t)
  {
    while (holds)
    {
      isHeld = true;
      holds.wait(true);
    }
    isHeld = false;
  }
  void hdEndFrame(std::uint32_t) {}
  void hdEnable(std::uint32_t what)
  {
    outputOn = what == 0x4000 ? 1 : 0;
  }
  void hdGetDoublev(std::uint32_t what, double* values)
  {
    if (what == 0x2050)
    {
      values[0] = place_mm[0], values[1] = place_mm[1], values[2] = place_mm[2];
    }
    else if (what == 0x2051)
    {
      values[0] = speed_mm_per_s, values[1] = values[2] = 0.0;
    }
    else if (what == 0x2052)
    {
      for (int i = 0; i < 16; ++i)
      {
        values[i] = i % 5 == 0 ? 1.0 : 0.0;
      }
      values[0] = values[5] = 0.0, values[1] = turned, values[4] = -turned; // a quarter turn about z, column by column
    }
  }
  void hdGetIntegerv(std::uint32_t, int* values)
  {
    values[0] = 2;
  }
  void hdSetDoublev(std::uint32_t what, const double* values)
  {
    const bool isPush = values[0] != 0.0 || values[1] != 0.0 || values[2] != 0.0;
    pushes += what == 0x2700 && isPush ? 1 : 0;
    for (int i = 0; i < 3 && what == 0x2700; ++i)
    {
      force[i] = values[i];
      lastPush[i] = isPush ? values[i] : lastPush[i].load();
    }
  }
  std::uint64_t hdScheduleAsynchronous(Callback call, void* of, std::uint16_t)
  {
    callback = call;
    data = of;
    return 1;
  }
  void hdUnschedule(std::uint64_t)
  {
    callback = nullptr;
  }
  void hdStartScheduler()
  {
    runs = true;
    scheduler = std::thread(
      []
      {
        while (runs)
        {
          if (rate_Hz > 0)
          {
            callback(data);
            ++calls;
          }
          std::this_thread::sleep_for(std::chrono::microseconds(rate_Hz > 0 ? 1000000 / rate_Hz : 1000));
        }
      });
  }
  void hdStopScheduler()
  {
    runs = false;
    scheduler.join();
  }
  Error hdGetError()
  {
    return { failure, 0, 5 };
  }
  // Requests and settings of a test.
  double fakeForce(int axis)
  {
    return force[axis];
  }
  double fakeLastPush(int axis)
  {
    return lastPush[axis];
  }
  int fakeCalls()
  {
    return calls;
  }
  /// Forces so far that were one, and devices that are open.
  int fakePushes()
  {
    return pushes;
  }
  int fakeOpened()
  {
    return opened;
  }
  int fakeOutput()
  {
    return outputOn;
  }
  /// 0: the scheduler makes no call by itself.
  void fakeRate(int Hz)
  {
    rate_Hz = Hz;
  }
  /// One call of the scheduler, now, in the thread of the test; none where nothing is scheduled.
  void fakeCall()
  {
    if (callback != nullptr)
    {
      callback(data);
      ++calls;
    }
  }
  /// Place of the hand [m], and its speed along x [m/s].
  void fakePlace(double x, double y, double z, double along_m_per_s)
  {
    constexpr double perMetre = 1000.0;
    place_mm[0] = perMetre * x;
    place_mm[1] = perMetre * y;
    place_mm[2] = perMetre * z;
    speed_mm_per_s = perMetre * along_m_per_s;
  }
  /// A factor on the numbers of the turn, which is a turn with 1.
  void fakeTurn(double factor)
  {
    turned = factor;
  }
  /// A call does not return from the beginning of its frame any more, until 0 is given.
  void fakeHold(int on)
  {
    holds = on != 0;
    holds.notify_all();
  }
  int fakeIsHeld()
  {
    return isHeld ? 1 : 0;
  }
  void fakeFail(std::uint32_t code)
  {
    failure = code;
  }
}
