// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkTouchAlongPath
 * @brief   the force along a given path of the hand over a surface, without a device
 *
 * Port 0: the surface (any data set or composite; W [u]). Port 1: the path of the hand, poly data with one polyline, or
 * points without lines that are taken in their order. Port 2, optional: numbers in space (any data set or composite)
 * that are felt as a field as well; where an array of a field is chosen and port 2 has no data of its own, port 0 is
 * felt as a field alone, whose proxy and contacts are those of the output. Each point of the path is one tick of the
 * same function that drives a device, without a device's limits: F = Stiffness (proxy - hand) / Scale. Output: the path
 * of the proxy as a polyline with the point arrays
 *
 *     Force     (n, 3) double  on the hand, in W [N]
 *     Depth     (n)    double  distance of hand and proxy [u]
 *     Contacts  (n)    int     planes that push, coplanar ones counted once
 *     Device    (n, 3) double  the hand, i.e. the input path [u]
 *     Time      (n)    double  of the tick [s]
 *
 * Where port 0 is the output of vtkHapticSoftBody it gives way; see LowRate.
 *
 * Port 3, optional: a mesh that the hand holds at the origin of its frame, in place of a ball, and that turns as the
 * TurnArray of the path says. Each row is as far as the tool comes without meeting anything, in unlimited time, from
 * the row before; the points of the output are where its origin is. It feels surfaces as they are, without a field
 * and material from data, and rubs by FrictionKinetic, up to 1 and to the static one, on all that it touches. Besides
 * there are
 *
 *     Torque    (n, 3) double  on the hand, about the handle, in W [N m]
 *     Turn      (n, 4) double  of the tool, a unit quaternion w x y z
 *     Angle     (n)    double  between the turns of hand and tool [degrees]
 *
 * Where port 0 is the output of vtkHapticMechanism, its laws act on what the hand holds, held by Stiffness and, where
 * Lever is not 0, turned by Stiffness (Lever / Scale)^2; at 0 it turns freely. The points of the output are where its
 * origin is. Besides there are Torque and Turn as of a tool, and
 *
 *     Residual       (n)    double  by how much a law is not met [u]
 *     Force of NAME  (n, 3) double  of the law NAME on its first body, in W [N]
 *     Phase of NAME  (n)    double  0: open, 1: closed, 2: slips, 3: inside, 4: gone
 *     Inside of NAME (n)    double  of the shaft, beyond its hole [u]
 *
 * Point i of the output belongs to point i of the path. Bad input is an error of one line and leaves the output empty.
 */
#ifndef vtkTouchAlongPath_h
#define vtkTouchAlongPath_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkTouchAlongPathDescribed.h" // for the settings of a field

#include <cstdint>
#include <functional> // for an argument
#include <memory>     // for a member
#include <string>     // for the return type

namespace palpate
{
class BodyMaker;
class PathTouch;
enum class Fault : std::uint8_t;
struct HapticParameters;
struct MechanismHold;
} // namespace palpate

struct vtkHapticFieldArrays;
struct vtkHapticFieldBeside;
struct vtkHapticHandPath;
struct vtkHapticMaterialSettings;
struct vtkHapticTouchedField;

class VTKHAPTICPIPELINE_EXPORT vtkTouchAlongPath : public vtkPolyDataAlgorithm
{
public:
  static vtkTouchAlongPath* New();
  vtkTypeMacro(vtkTouchAlongPath, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The path of the hand: the same as SetInputConnection(1, port).
  void SetPathConnection(vtkAlgorithmOutput* path);
  void SetPathData(vtkDataObject* path);

  ///@{
  /// Spring between hand and proxy [N/m], >= 0. Default 1000.
  vtkSetMacro(Stiffness, double);
  vtkGetMacro(Stiffness, double);
  ///@}

  ///@{
  /// Radius of the ball that touches [u], >= 0. Default 0: a point.
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /// Radius of the tubes as which lines are touched [u], >= 0. Default 0: they are not.
  vtkSetMacro(LineRadius, double);
  vtkGetMacro(LineRadius, double);
  ///@}

  ///@{
  /**
   * Coulomb friction between ball and surface [1]: what holds at rest, 0 (none, default) to 10, and what brakes while
   * it slides, 0 (default) to the static one; more is an error.
   */
  vtkSetMacro(FrictionStatic, double);
  vtkGetMacro(FrictionStatic, double);
  vtkSetMacro(FrictionKinetic, double);
  vtkGetMacro(FrictionKinetic, double);
  ///@}

  ///@{
  /// Smooth forces over facets, never across edges sharper than 30 degrees. Default off.
  vtkSetMacro(ForceShading, bool);
  vtkGetMacro(ForceShading, bool);
  vtkBooleanMacro(ForceShading, bool);
  ///@}

  /** @name Material from data
   * From an array of the points, or else the cells, of a surface (cells: the mean of those around a point): its name
   * ("", default: none), its component (-1, default: the length of a vector, the value of a scalar), a data range
   * (equal ends, default: the array's own) and what its two ends feel like: linear between, level beyond. Where a value
   * is not finite the surface's own is felt. An array that is missing or cannot be used is an error.
   */
  ///@{
  /// [N/m], >= 0, default 100 to 1000: what is felt, up to the stiffness of the spring between hand and proxy.
  void SetStiffnessArray(const char* name);
  const char* GetStiffnessArray() const;
  void SetStiffnessComponent(int component);
  int GetStiffnessComponent() const;
  void SetStiffnessDataRange(double low, double high);
  double* GetStiffnessDataRange() VTK_SIZEHINT(2);
  void SetStiffnessFeltRange(double atLow, double atHigh);
  double* GetStiffnessFeltRange() VTK_SIZEHINT(2);
  ///@}

  ///@{
  /// [1], 0 to 10, default 0 to 1: at rest and sliding alike.
  void SetFrictionArray(const char* name);
  const char* GetFrictionArray() const;
  void SetFrictionComponent(int component);
  int GetFrictionComponent() const;
  void SetFrictionDataRange(double low, double high);
  double* GetFrictionDataRange() VTK_SIZEHINT(2);
  void SetFrictionFeltRange(double atLow, double atHigh);
  double* GetFrictionFeltRange() VTK_SIZEHINT(2);
  ///@}

  ///@{
  /// [u], default 0 to 1: heights, of which the highest is the surface and lower ones are hollows; their mean for a
  /// hand too fast for them.
  void SetTextureArray(const char* name);
  const char* GetTextureArray() const;
  void SetTextureComponent(int component);
  int GetTextureComponent() const;
  void SetTextureDataRange(double low, double high);
  double* GetTextureDataRange() VTK_SIZEHINT(2);
  void SetTextureFeltRange(double atLow, double atHigh);
  double* GetTextureFeltRange() VTK_SIZEHINT(2);
  ///@}

  ///@{
  /// The field: the same as SetInputConnection(2, port).
  void SetFieldConnection(vtkAlgorithmOutput* field);
  void SetFieldData(vtkDataObject* field);
  ///@}

  ///@{
  /// Other data whose array FieldOther, or the one that is called as FieldArray, the values of the field are compared
  /// with: the same as SetInputConnection(4, port).
  void SetComparedConnection(vtkAlgorithmOutput* compared);
  void SetComparedData(vtkDataObject* compared);
  ///@}

  ///@{
  /// To whose points and lines the hand snaps, in place of what is found in the values: SetInputConnection(5, port).
  void SetSnapConnection(vtkAlgorithmOutput* snap);
  void SetSnapData(vtkDataObject* snap);
  ///@}

  /** @name Numbers in space
   * Which arrays of the field are felt, and how: the settings of a session with these names, with their units, ranges
   * and defaults (plugin/README.md). What is on and cannot be felt is an error. */
  ///@{
  vtkHapticTouchFieldSettingsMacro();
  ///@}

  ///@{
  /// Scene units per metre of the hand, > 0. Default 1.
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /// Ticks per second [Hz], > 0. Default 1000. Not used when there is a TimeArray.
  vtkSetMacro(Rate, double);
  vtkGetMacro(Rate, double);
  ///@}

  ///@{
  /// Point array of the path with the time of each tick [s], increasing. Default none: times come from Rate.
  vtkSetStringMacro(TimeArray);
  vtkGetStringMacro(TimeArray);
  ///@}

  ///@{
  /// The tool: the same as SetInputConnection(3, port).
  void SetToolConnection(vtkAlgorithmOutput* tool);
  void SetToolData(vtkDataObject* tool);
  ///@}

  ///@{
  /// Point array of the path with the turn of the hand, a unit quaternion w x y z. Default none: it does not turn.
  vtkSetStringMacro(TurnArray);
  vtkGetStringMacro(TurnArray);
  ///@}

  ///@{
  /// What a turn of the tool by 1 rad weighs as a way [u], >= 0: the stiffness of turning is Stiffness (Lever /
  /// Scale)^2. Default 0: that of its mesh about the handle, sqrt(2/3 mean |p|^2).
  vtkSetMacro(Lever, double);
  vtkGetMacro(Lever, double);
  ///@}

  ///@{
  /// Whether a spring leads from the hand to the tool, in place of what its contacts push with. Default off.
  vtkSetMacro(VirtualCoupling, bool);
  vtkGetMacro(VirtualCoupling, bool);
  vtkBooleanMacro(VirtualCoupling, bool);
  ///@}

  ///@{
  /// How often a soft body is computed [Hz], >= 0: what is found arrives one period later. Default 30; 0: the body is
  /// at rest in every tick, which is the reference.
  vtkSetMacro(LowRate, double);
  vtkGetMacro(LowRate, double);
  ///@}

protected:
  vtkTouchAlongPath();
  ~vtkTouchAlongPath() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  palpate::HapticParameters Parameters() const;
  /// Empty, or what cannot be used.
  std::string CheckParameters() const;
  void ChangeMaterial(const std::function<void(vtkHapticMaterialSettings&)>& change);
  void ChangeField(const std::function<void(vtkHapticFieldArrays&)>& change);
  /// A setting of the field's plan, by its name.
  void SetField(const char* name, double value);
  double GetField(const char* name) const;
  /// What the hand feels; null with a problem. `field`: null where no numbers are felt.
  std::unique_ptr<palpate::PathTouch> Prepare(vtkDataObject* input, vtkDataObject* field,
    const vtkHapticFieldBeside& beside, const vtkHapticHandPath& path, std::string& problem) const;
  /// Warns of what of it gave no force, or another than was asked for.
  void TellOf(const palpate::PathTouch& touch, palpate::Fault fault);
  /// With a tool in place of a ball; false with an error.
  bool TouchWithTool(vtkDataObject& surface, vtkDataObject& tool, const vtkHapticHandPath& path, vtkPolyData& output);
  /// Why a tool does not feel what else is set; empty: nothing else is.
  std::string BesideTool();
  /// What is asked for that only surfaces have; "": nothing.
  const char* OfSurfacesAlone();
  /// With what a mechanism holds in the hand; false with an error.
  bool TouchMechanism(vtkDataObject& mechanism, const vtkHapticHandPath& path, vtkPolyData& output);
  palpate::MechanismHold Hold() const;
  /// Why a mechanism does not feel what else is set; empty: nothing else is.
  std::string BesideMechanism();
  /// Why a soft body is not felt with what else is set; empty: it is.
  std::string BesideBody() const;
  /// Has a soft body give way; or a problem.
  void Press(vtkDataObject* body, palpate::PathTouch& touch, std::string& problem) const;
  /// Warns of what of it was left out, and of large strain.
  void TellOfBody(const palpate::BodyMaker& body);
  /// Reports progress; false when someone asked to stop.
  bool Goes(double progress);

  double Stiffness = 1000.0;
  double Radius = 0.0;
  double LineRadius = 0.0;
  double FrictionStatic = 0.0;
  double FrictionKinetic = 0.0;
  bool ForceShading = false;
  double Scale = 1.0;
  double Rate = 1000.0;
  char* TimeArray = nullptr;
  char* TurnArray = nullptr;
  double Lever = 0.0;
  bool VirtualCoupling = false;
  double LowRate = 30.0;
  std::unique_ptr<vtkHapticMaterialSettings> Materials;
  std::unique_ptr<vtkHapticTouchedField> Field;
};

#endif
