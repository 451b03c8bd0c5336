// SPDX-License-Identifier: GPL-3.0-or-later
// A library with the names of Force Dimension's. PALPATE_FAKE_OLD: without those of newer versions. PALPATE_FAKE_BARE:
// without that of a gripper.
#include <atomic>

namespace
{
std::atomic<double> force[6], place_m[3] = { 0.01, 0.02, -0.03 }, speed_m_per_s = 0.1, turned = 1.0, opening_rad = 0.0;
std::atomic<int> watchdog = -1, enabled = -1, opened = 0, failing = 0;
std::atomic<int> readings = 0, gripAnswer = -1, gripAsked = 0;
std::atomic<int> found = 1, failingCall = 0, unwatched = 0;
std::atomic<bool> holds = false, isHeld = false, isSilent = false;

/// Of a call that may be the one that fails, without doing anything.
int resultOf(int call)
{
  return failingCall == call ? -1 : 0;
}
} // namespace

extern "C"
{
  int dhdGetDeviceCount()
  {
    return found;
  }
  int dhdOpenID(char id)
  {
    watchdog = -1;
    return failing > 0 ? -1 : (++opened, id);
  }
  int dhdClose(char)
  {
    return --opened;
  }
  const char* dhdErrorGetLastStr()
  {
    return isSilent ? nullptr : "made-up failure";
  }
  int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double (*frame)[3], char)
  {
    while (holds)
    {
      isHeld = true;
      holds.wait(true);
    }
    isHeld = false;
    ++readings;
    *x = place_m[0];
    *y = place_m[1];
    *z = place_m[2];
    frame[0][0] = 0.0, frame[0][1] = -turned, frame[0][2] = 0.0; // a quarter turn about z
    frame[1][0] = turned, frame[1][1] = 0.0, frame[1][2] = 0.0;
    frame[2][0] = 0.0, frame[2][1] = 0.0, frame[2][2] = 1.0;
    return failing > 0 ? -1 : 0;
  }
  int dhdGetLinearVelocity(double* x, double* y, double* z, char)
  {
    *x = speed_m_per_s;
    *y = *z = 0.0;
    return resultOf(4);
  }
  int dhdGetButtonMask(char)
  {
    return 3;
  }
  int dhdEnableForce(unsigned char on, char)
  {
    if (resultOf(2) < 0 && on != 0)
    {
      return -1;
    }
    unwatched += on != 0 && watchdog < 0 ? 1 : 0;
    enabled = on;
    for (int i = 0; i < 6 && on == 0; ++i)
    {
      force[i] = 0.0;
    }
    return 0;
  }
#ifndef PALPATE_FAKE_BARE
  int dhdGetGripperAngleRad(double* angle_rad, char)
  {
    ++gripAsked;
    *angle_rad = opening_rad;
    return gripAnswer;
  }
#endif
#ifndef PALPATE_FAKE_OLD
  int dhdSetWatchdog(unsigned char tens_ms, char)
  {
    watchdog = resultOf(1) < 0 ? watchdog.load() : tens_ms;
    return resultOf(1);
  }
#endif
  int dhdSetForceAndTorqueAndGripperForce(
    double fx, double fy, double fz, double tx, double ty, double tz, double, char)
  {
    const double all[6] = { fx, fy, fz, tx, ty, tz };
    for (int i = 0; i < 6 && resultOf(3) == 0; ++i)
    {
      force[i] = all[i];
    }
    return resultOf(3);
  }
  // Requests and settings of a test.
  double fakeForce(int axis)
  {
    return force[axis];
  }
  int fakeWatchdog()
  {
    return watchdog;
  }
  /// How often force was enabled without a watchdog.
  int fakeUnwatched()
  {
    return unwatched;
  }
  int fakeEnabled()
  {
    return enabled;
  }
  /// How many devices the library sees; below 0: an error.
  void fakeCount(int count)
  {
    found = count;
  }
  /// 1: the call for the watchdog fails, 2: that which enables force, 3: that for a force, 4: for the velocity; 0:
  /// none.
  void fakeFailAt(int call)
  {
    failingCall = call;
  }
  /// An error has no text.
  void fakeSilent(int on)
  {
    isSilent = on != 0;
  }
  int fakeOpened()
  {
    return opened;
  }
  /// Place of the hand [m], and its speed along x [m/s].
  void fakePlace(double x, double y, double z, double along_m_per_s)
  {
    place_m[0] = x;
    place_m[1] = y;
    place_m[2] = z;
    speed_m_per_s = along_m_per_s;
  }
  /// A factor on the numbers of the turn, which is a turn with 1.
  void fakeTurn(double factor)
  {
    turned = factor;
  }
  /// The opening of the gripper [rad]; `answer`: of the call for it, below 0 on an arm that has none.
  void fakeGrip(double rad, int answer)
  {
    opening_rad = rad;
    gripAnswer = answer;
  }
  /// How often the opening was asked for in so many readings.
  int fakeGripAsked()
  {
    return gripAsked;
  }
  int fakeReadings()
  {
    return readings;
  }
  void fakeFail(int on)
  {
    failing = on;
  }
  /// The call for the place does not return any more, until 0 is given.
  void fakeHold(int on)
  {
    holds = on != 0;
    holds.notify_all();
  }
  int fakeIsHeld()
  {
    return isHeld ? 1 : 0;
  }
}
