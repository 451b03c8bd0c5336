// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFollowingArms_h
#define vtkHapticFollowingArms_h

class vtkHapticSession;
class vtkSMProxy;
struct vtkHapticViewScan;

/// The arms of the pipeline that are drawn at the hand of a session (FollowHand of vtkHapticArm). A source on a server
/// stays at its typed hand. All that filters make of such an arm follows the hand too, and is not touched.
class vtkHapticFollowingArms
{
public:
  /// Has each arm drawn at the hand while it touches, else at its typed hand. `view`: of the pipeline.
  void Follow(vtkHapticSession& session, vtkSMProxy* view);
  /// Leaves them, and all that filters make of them, out of the surfaces, with the reason.
  void Change(vtkHapticSession* session, vtkSMProxy* view, vtkHapticViewScan& scan);
  void Forget() {} // an arm keeps nothing of a session
};

#endif
