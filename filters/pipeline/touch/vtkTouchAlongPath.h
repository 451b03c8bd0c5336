// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkTouchAlongPath
 * @brief   the force along a given path of the hand over a surface, without a device
 *
 * Port 0: the surfaces (any data set or composite, each connection one surface; W [u]). Port 1: the path of the hand,
 * poly data with one polyline, or points without lines that are taken in their order. Port 2, optional: numbers in
 * space (any data set or composite) that are felt as a field as well; where an array of a field is chosen and port 2
 * has no data of its own, port 0 is felt as a field alone, whose proxy and contacts are those of the output. Each point
 * of the path is one tick of the same function that drives a device, without a device's limits: F = Stiffness (proxy -
 * hand) / Scale. Output: the path of the proxy as a polyline with the point arrays
 *
 *     Force     (n, 3) double  on the hand, in W [N]
 *     Depth     (n)    double  distance of hand and proxy [u]
 *     Contacts  (n)    int     planes that push, coplanar ones counted once
 *     Device    (n, 3) double  the hand, i.e. the input path [u]
 *     Time      (n)    double  of the tick [s]
 *
 * A connection of port 0 with the output of vtkHapticSoftBody is soft; see SoftRate.
 *
 * Port 3, optional: a mesh that the hand holds at the origin of its frame, in place of a ball, and that turns as the
 * TurnArray of the path says. Each row is as far as the tool comes without meeting anything, in unlimited time, from
 * the row before; the points of the output are where its origin is. The tool feels surfaces as they are, without a
 * field and material from data, with the friction FrictionKinetic, up to 1 and to the static one, on all that it
 * touches. On a soft body it is a closed mesh, and further surfaces, which both touch, are closed, too: contacts are
 * found as in a mechanism, and a row is one tick. Besides there are
 *
 *     Torque    (n, 3) double  on the hand, about the handle, in W [N m]
 *     Turn      (n, 4) double  of the tool, a unit quaternion w x y z
 *     Angle     (n)    double  between the turns of hand and tool [degrees]
 *
 * Where port 0 is the output of vtkHapticMechanism, its constraints act on the held body, which is coupled by Stiffness
 * and turned by MechanismTurning, or without one by Stiffness (ToolLever / Scale)^2; without both it turns freely. The
 * points of the output are where its origin is. Besides there are Torque and Turn as of a tool, and
 *
 *     Residual       (n)    double  by how much a constraint is not met [u]
 *     Force of NAME  (n, 3) double  of the constraint NAME on its first body, in W [N]
 *     Phase of NAME  (n)    double  0: open, 1: closed, 2: slips, 3: inside, 4: gone
 *     Inside of NAME (n)    double  of the shaft, beyond its hole [u]
 *
 * Point i of the output belongs to point i of the path. Bad input is an error of one line and leaves the output empty.
 */
#ifndef vtkTouchAlongPath_h
#define vtkTouchAlongPath_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <map>    // for a member
#include <memory> // for a member
#include <string> // for a member
#include <vector> // for a member

namespace palpate
{
struct PathInputs;
struct PathReport;
class PathRunner;
class SettingStore;
struct SettingValue;
} // namespace palpate

class VTKHAPTICPIPELINE_EXPORT vtkTouchAlongPath : public vtkPolyDataAlgorithm
{
public:
  static vtkTouchAlongPath* New();
  vtkTypeMacro(vtkTouchAlongPath, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The same as SetInputConnection(port, ...) and SetInputDataObject(port, ...): the path of the hand (port 1), the
  /// field (2), the tool (3), other data that the values of the field are compared with (4), data to whose points and
  /// lines the hand snaps in place of extrema of the values (5), and a closed surface that is a loose body (6).
  ///@{
  void SetPathConnection(vtkAlgorithmOutput* path) { this->SetInputConnection(1, path); }
  void SetPathData(vtkDataObject* path) { this->SetInputDataObject(1, path); }
  void SetFieldConnection(vtkAlgorithmOutput* field) { this->SetInputConnection(2, field); }
  void SetFieldData(vtkDataObject* field) { this->SetInputDataObject(2, field); }
  void SetToolConnection(vtkAlgorithmOutput* tool) { this->SetInputConnection(3, tool); }
  void SetToolData(vtkDataObject* tool) { this->SetInputDataObject(3, tool); }
  void SetComparedConnection(vtkAlgorithmOutput* compared) { this->SetInputConnection(4, compared); }
  void SetComparedData(vtkDataObject* compared) { this->SetInputDataObject(4, compared); }
  void SetSnapConnection(vtkAlgorithmOutput* snap) { this->SetInputConnection(5, snap); }
  void SetSnapData(vtkDataObject* snap) { this->SetInputDataObject(5, snap); }
  void SetLooseConnection(vtkAlgorithmOutput* loose) { this->SetInputConnection(6, loose); }
  void SetLooseData(vtkDataObject* loose) { this->SetInputDataObject(6, loose); }
  ///@}

  /**
   * A setting of a session that is felt along a path too, by its name, with its unit and range (plugin/README.md):
   * Stiffness (1000 N/m by default here), Radius, LimitRadius (off), LineRadius, LinesAsWalls, Scale (1 u/m),
   * ForceShading, a constant force, friction, the arrays of a material, those whose names begin with Field, ToolLever
   * and ToolCoupling of a tool, SoftRate of a soft body or a mechanism (from 0 on: at 0 the body is at rest in every
   * tick, which is the reference) and MechanismTurning. An unusable value is an error when the filter runs.
   */
  ///@{
  void SetSetting(const char* name, double value); ///< on and off are 1 and 0, choices count from 0 on
  void SetSetting(const char* name, double low, double high);
  void SetSetting(const char* name, double x, double y, double z);
  void SetSetting(const char* name, const char* text);
#ifndef __VTK_WRAP__
  void SetSetting(const char* name, int value); ///< so that 0 is a number
#endif
  double GetSetting(const char* name) const;  ///< the first number; NaN where there is none
  int GetSettingSize(const char* name) const; ///< of numbers; 0 for a text
  static std::string GetSettingNames();       ///< of all, with spaces between them
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
  /// Point array of the path with the turn of the hand, a unit quaternion w x y z. Default none: it does not turn.
  vtkSetStringMacro(TurnArray);
  vtkGetStringMacro(TurnArray);
  ///@}

  ///@{
  /// Length of the directions of a field up to which they are not followed and do not push, >= 0 and, where it is not
  /// 0, below FieldFullSpeed. Default 0.
  vtkSetMacro(NoSpeed, double);
  vtkGetMacro(NoSpeed, double);
  ///@}

  ///@{
  /// Density of the loose body [kg/m3], > 0; one unit is 1 / Scale metres. Default 1000: as water.
  vtkSetMacro(Density, double);
  vtkGetMacro(Density, double);
  ///@}

  ///@{
  /// Whether the output has the array Cost (n) double: the time that each tick took [us]. Default off.
  vtkSetMacro(WithCost, bool);
  vtkGetMacro(WithCost, bool);
  vtkBooleanMacro(WithCost, bool);
  ///@}

#ifndef __VTK_WRAP__
  /// Data of a port by the name that sentences have: of port 0 one surface more, of the others the only data.
  void AddNamed(int port, const std::string& name, vtkDataObject* data);
  /// All settings, as pathSettings() has them.
  void SetSettings(const palpate::SettingStore& settings);
  /// Of the last run, with settings by their names in braces.
  const palpate::PathReport& GetReport() const
  {
    return *this->Report;
  }
#endif

protected:
  vtkTouchAlongPath();
  ~vtkTouchAlongPath() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  void Put(const char* name, const palpate::SettingValue& value);
  /// Name of the data of a port in sentences.
  std::string NameOf(int port, std::size_t connection) const;
  bool FeelsField() const;
  /// The input for the data of all ports, or a problem. `given`: of port 0, before its pieces were brought together.
  struct WholeInputs;
  palpate::PathInputs Read(const WholeInputs& whole, vtkDataObject& given, std::string& problem) const;
  void ReadTouched(
    vtkDataObject& data, const std::string& name, palpate::PathInputs& inputs, std::string& problem) const;
  void ReadField(const WholeInputs& whole, palpate::PathInputs& inputs, std::string& problem) const;
  /// Follows the path; false when someone asked to stop.
  bool Follow(palpate::PathRunner& runner, std::size_t count, vtkPolyData& output);
  /// Warns of the notes for a person, or errs.
  int Tell();

  std::unique_ptr<palpate::SettingStore> Settings;
  std::unique_ptr<palpate::PathReport> Report;
  std::map<int, std::vector<std::string>> Names; ///< of the connections of each port
  double Rate = 1000.0;
  char* TimeArray = nullptr;
  char* TurnArray = nullptr;
  double NoSpeed = 0.0;
  double Density = 1000.0;
  bool WithCost = false;
};

#endif
