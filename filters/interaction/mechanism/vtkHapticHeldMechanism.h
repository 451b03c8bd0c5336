// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticHeldMechanism_h
#define vtkHapticHeldMechanism_h

#include "haptics/session/mechanism/MechanismWorker.h"
#include "haptics/tick/base/HapticState.h"
#include "vtkBoundingBox.h"
#include "vtkHapticFeltSource.h"
#include "vtkHapticHeldAxis.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

class vtkTable;

/// The mechanism of a session: its source, its plan, its status.
class vtkHapticHeldMechanism : public vtkHapticFeltSource
{
public:
  std::string Constraints; ///< a list of constraints in place of those of its scene file; "": those
  double Rate_Hz = 30.0;   ///< snapshots of its soft bodies a second

  bool DrawnElsewhere = false;

  const char* Setting() const override { return "MechanismSource"; }
  const char* Subject() const override { return "mechanism"; }
  bool IsHeld() const override { return true; }
  void Choose(palpate::HapticSession& core) const override;
  /// The same data by other constraints.
  std::string TakeAgain();
  /// The same bodies and constraints, which begin anew where the scene file has them; false: there are none.
  bool BeginAgain();
  /// Why a list of constraints would end a mechanism that is held without a fault now; "": it would not.
  std::string RefusalOf(const std::string& laws, const palpate::HapticSession& core);
  /// The list of constraints with another one, as an object of a scene file, or with one less; "" with a problem.
  std::string With(const std::string& law, std::string& problem) const;
  std::string Without(const std::string& name, std::string& problem) const;
  /// The place of a constraint in the mechanism; -1: there is none.
  int IndexOf(const std::string& name) const;
  /// Whether the servo numbers constraints as IndexOf() does: these are the constraints that it has.
  bool IsFelt() const { return this->Felt; }
  /// The bodies that `shapes` has where they are at first, where they are now and as they are bent; false, and
  /// unchanged: they are not held. While other constraints of the same bodies are computed they are where they were.
  bool Move(vtkPolyData& shapes) const;
  /// The held body, in its own frame; null: none.
  vtkPolyData* HeldShape() const { return this->Seen.Held ? this->Held.Get() : nullptr; }
  /// The held rod: from the hand to its tip; nothing: no mechanism is held.
  std::optional<vtkHapticHeldAxis> Axis() const;
  /// The box of the bodies that the held one can meet, as they are at first [u].
  vtkBoundingBox MetBounds() const;
  /// Where the hand was when its soft bodies were computed last; null: they are not held, or there are none.
  const palpate::Vec3* SoftHand_W() const;
  /// A row a constraint: Constraint, Kind, A, B, Numbers, Phase, Force [N], Inside [u].
  void FillTable(vtkTable& table) const;

  bool IsWire() const; ///< whether a wire is chosen
  /// The report of the tick on a wire; of another mechanism zeros.
  const palpate::WireReport& Wire() const { return this->Now.wire; }
  double WallPlace[3] = { 0.0, 0.0, 0.0 }; ///< of the largest force of the wall on a wire [u]
  double Depth = 0.0; ///< the hand's displacement along the held body since nothing pushed, or the length of a wire out
                      ///< of its sheath [u]
  double Pose[7] = { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 };     ///< of the held body, where it is felt
  double HandPose[7] = { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 }; ///< and where the hand would have it
  vtkBoundingBox Bounds;                                      ///< of its bodies as they are at first

private:
  /// How bodies were when constraints of theirs were felt last.
  struct Sight
  {
    bool Held = false;
    decltype(palpate::MechanismNow::pose_W) Pose_W{};
    std::vector<palpate::SeenBody> Soft;
    std::vector<palpate::Vec3> Wire_W;
  };
  std::string Convert(vtkDataObject* data, const std::string& reason) override;
  bool IsMade() const override { return this->Inputs != nullptr; }
  void Look(palpate::HapticSession& core, const palpate::HapticState& state, double now_s) override;
  std::string Sentence(palpate::HapticSession& core, const palpate::HapticState& state) const override;
  const char* Absent() const override;
  std::string FeltText(bool runs) const;
  std::size_t HeldBody() const;

  std::vector<vtkBoundingBox> BodyBounds;                ///< one a body
  std::string File, Folder;                              ///< text of the scene file, and where that lies
  std::shared_ptr<const palpate::TriangleMesh> Vessel_W; ///< of a wire that names no file of one; else null
  bool OfServer = false;
  std::shared_ptr<const palpate::MechanismInputs> Inputs;
  std::vector<palpate::MechanismSoftInput> Read; ///< its soft bodies, for the next constraints
  palpate::BodiesAtRest AtRest;                  ///< the same, once made: other constraints are judged by them
  vtkSmartPointer<vtkPolyData> Held;             ///< the shape of the body in the hand
  palpate::MechanismStatus Status;
  palpate::MechanismNow Now;
  bool Felt = false; ///< Now is of these constraints
  Sight Seen;
  palpate::Vec3 Begin_W = palpate::Vec3::Zero(); ///< where that displacement begins
};

#endif
