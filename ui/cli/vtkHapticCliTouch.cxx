// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliCommands.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "haptics/session/path/PathRunner.h"
#include "haptics/session/settings/AutoChoice.h"
#include "vtkDoubleArray.h"
#include "vtkHapticBodyFile.h"
#include "vtkHapticCliOutput.h"
#include "vtkHapticCliPath.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticCliScene.h"
#include "vtkHapticMechanismData.h"
#include "vtkHapticReaders.h"
#include "vtkHapticSoftBodyData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTouchAlongPath.h"

namespace
{
/// An option that a kind does not feel would be lost; the filter refuses settings, this function the options that are
/// none.
void CheckKinds(const vtkHapticCliTouchOptions& options, bool mechanism)
{
  const bool tool = !options.Tool.empty(), soft = options.Soft.Young_Pa.has_value(), loose = !options.Loose.empty();
  const std::string asked = !mechanism && !tool && !soft && !loose  ? ""
                            : options.Field.Any()                   ? "--field"
                            : options.TwoD                          ? "--two-d"
                            : mechanism && soft                     ? "--young"
                            : mechanism && tool                     ? "--tool"
                            : mechanism && loose                    ? "--loose"
                            : loose && options.VirtualCoupling      ? "--virtual-coupling"
                            : soft && options.VirtualCoupling       ? "--virtual-coupling"
                            : (mechanism || soft) && options.Iso    ? "--iso"
                            : mechanism && options.Files.size() > 1 ? "another file"
                                                                    : "";
  if (!asked.empty())
  {
    const char* const kind = mechanism      ? "a mechanism"
                             : loose        ? "a hand among loose bodies"
                             : tool && soft ? "a tool on a soft body"
                             : tool         ? "a tool"
                                            : "a soft body";
    throw vtkHapticCliProblem(asked + ": " + kind + " does not feel it; omit one of the two");
  }
}

/// Surfaces are loose by their names, so that both would be.
void CheckLooseOnce(const vtkHapticCliTouchOptions& options)
{
  std::error_code ignored;
  for (const std::string& file : options.Files)
  {
    if (std::filesystem::equivalent(file, options.Loose, ignored))
    {
      throw vtkHapticCliProblem(options.Loose + ": one file cannot be both FILE and --loose; omit one of the two");
    }
  }
}

void CheckPlaneAlone(const vtkHapticCliTouchOptions& options)
{
  if (options.TwoD && (options.Iso || options.Field.Any()))
  {
    throw vtkHapticCliProblem(
      std::string("--two-d cannot be combined with ") + (options.Iso ? "--iso" : "--field") + "; omit one of the two");
  }
}

vtkSmartPointer<vtkPolyData> DataOf(const std::vector<palpate::PathSample>& path)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> times, turns;
  times->SetName("t");
  turns->SetName("q");
  turns->SetNumberOfComponents(4);
  for (const palpate::PathSample& sample : path)
  {
    const palpate::Quat& q = sample.hand_W.q;
    points->InsertNextPoint(sample.hand_W.p.data());
    times->InsertNextValue(sample.time_s);
    turns->InsertNextTuple4(q.w(), q.x(), q.y(), q.z());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(times);
  data->GetPointData()->AddArray(turns);
  return data;
}

void AddMechanism(const std::string& file, vtkTouchAlongPath& filter)
{
  const std::string folder = std::filesystem::path(file).parent_path().string();
  const vtkHapticMechanismResult read = vtkHapticReadMechanism(file);
  if (!read.Inputs)
  {
    throw vtkHapticCliProblem(read.Problem);
  }
  const vtkSmartPointer<vtkPolyData> shapes = vtkHapticMechanismShapes(read);
  vtkHapticDescribeMechanism(*shapes, read.Text, folder);
  filter.AddNamed(0, file, shapes);
}

void AddBody(const vtkHapticCliTouchOptions& options, const std::string& file, vtkTouchAlongPath& filter)
{
  const vtkHapticTetraFillResult read = vtkHapticReadBody(file, {});
  if (!read.Grid)
  {
    throw vtkHapticCliProblem(read.Problem);
  }
  vtkHapticCliNote(file, read.Note);
  vtkHapticSoftMaterial material{ *options.Soft.Young_Pa, options.Soft.Poisson, palpate::ElasticModel::Linear,
    1.0 / options.Settings.Number("Scale") };
  (void)vtkHapticModelOf(options.Soft.Model, material.Model); // the command line knows no other names
  std::string problem;
  if (!vtkHapticFixBody(*read.Grid, options.Soft.Fixed, read.Rough, problem) ||
      !vtkHapticDescribeBody(*read.Grid, material, "", problem))
  {
    throw vtkHapticCliProblem(file + ": cannot be a soft body: " + problem);
  }
  filter.AddNamed(0, file, read.Grid);
}

/// An iso value is of an image among the surfaces or of a mode.
void CheckIso(const vtkHapticCliTouchOptions& options, const std::vector<std::string>& surfaces)
{
  const bool image = std::ranges::any_of(surfaces, vtkHapticIsImageFile);
  const bool wall = std::ranges::count(options.Field.Modes, std::string_view("isosurface")) > 0;
  if (!options.Iso || image || wall)
  {
    return;
  }
  if (options.Field.Any())
  {
    throw vtkHapticCliProblem(
      "--iso has no effect: no --mode is isosurface, and no other image is touched; omit --iso");
  }
  vtkHapticCliCheckIsoIsUsed(surfaces, options.Iso);
}

/// Gives the filter all files.
void AddFiles(const vtkHapticCliTouchOptions& options, palpate::SettingStore& felt, vtkTouchAlongPath& filter)
{
  std::vector<std::string> files = options.Files;
  if (vtkHapticIsMechanismFile(files.front()))
  {
    AddMechanism(files.front(), filter);
    return;
  }
  if (options.Field.Any())
  {
    vtkHapticCliTakeField(options.Field, options.Settings, felt, files, filter);
  }
  if (options.Field.Snap.empty())
  {
    files.insert(files.end(), options.Field.Surfaces.begin(), options.Field.Surfaces.end());
  }
  if (options.Soft.Young_Pa)
  {
    AddBody(options, files.front(), filter);
    files.erase(files.begin());
  }
  CheckIso(options, files);
  for (const std::string& file : files)
  {
    if (options.TwoD && vtkHapticIsImageFile(file))
    {
      throw vtkHapticCliProblem(file + ": --two-d needs lines, not an image; extract curves first (Image Curves)");
    }
    filter.AddNamed(0, file, vtkHapticCliReadData(file, vtkHapticIsImageFile(file) ? options.Iso : std::nullopt));
  }
  if (!options.Loose.empty())
  {
    filter.AddNamed(6, options.Loose, vtkHapticCliReadData(options.Loose, {}));
    filter.SetDensity(options.Density);
  }
  if (!options.Tool.empty())
  {
    filter.AddNamed(3, "--tool: " + options.Tool, vtkHapticCliReadData(options.Tool, {}));
  }
}

/// Names in the CSV for the values of an array that a tool or a mechanism adds; none: it has none.
std::vector<std::string> NamesOf(const std::string& array)
{
  const auto of = [&array](const char* head) { return array.substr(std::string_view(head).size()); };
  if (array.starts_with("Force of "))
  {
    const std::string law = of("Force of ");
    return { law + "_fx", law + "_fy", law + "_fz" };
  }
  if (array.starts_with("Place of "))
  {
    return { "loose_x", "loose_y", "loose_z" };
  }
  if (array.starts_with("Turn of "))
  {
    return { "loose_qw", "loose_qx", "loose_qy", "loose_qz" };
  }
  return array == "Turn"                   ? std::vector<std::string>{ "proxy_qw", "proxy_qx", "proxy_qy", "proxy_qz" }
         : array == "Torque"               ? std::vector<std::string>{ "torque_x", "torque_y", "torque_z" }
         : array == "Residual"             ? std::vector<std::string>{ "residual" }
         : array == "Pushed"               ? std::vector<std::string>{ "pushed" }
         : array == "Turned"               ? std::vector<std::string>{ "turned" }
         : array == "Tip Force"            ? std::vector<std::string>{ "tip_force" }
         : array == "Wall Force"           ? std::vector<std::string>{ "wall_force" }
         : array == "Wall Place"           ? std::vector<std::string>{ "wall_x", "wall_y", "wall_z" }
         : array.starts_with("Phase of ")  ? std::vector{ of("Phase of ") + "_phase" }
         : array.starts_with("Inside of ") ? std::vector{ of("Inside of ") + "_inside" }
                                           : std::vector<std::string>{};
}

void Write(vtkPolyData& touched, vtkHapticCliOutput& output)
{
  vtkPointData& data = *touched.GetPointData();
  std::vector<vtkDataArray*> arrays{ data.GetArray("Time"), data.GetArray("Device"), touched.GetPoints()->GetData(),
    data.GetArray("Force"), data.GetArray("Contacts"), data.GetArray("Cost") };
  std::string header = vtkHapticCliOutput::TickColumns;
  for (int i = 0; i < data.GetNumberOfArrays(); ++i)
  {
    const std::vector<std::string> names = NamesOf(data.GetArrayName(i));
    std::ranges::for_each(names, [&header](const std::string& name) { header += "," + name; });
    if (!names.empty())
    {
      arrays.push_back(data.GetArray(i));
    }
  }
  output.Header(header);
  for (vtkIdType row = 0; row < touched.GetNumberOfPoints(); ++row)
  {
    std::vector<double> values;
    for (vtkDataArray* const array : arrays)
    {
      for (int component = 0; component < array->GetNumberOfComponents(); ++component)
      {
        values.push_back(array->GetComponent(row, component));
      }
    }
    output.Row(values);
  }
}

/// The filter's messages are told by the program with its own names.
void Run(const vtkHapticCliTouchOptions& options, vtkTouchAlongPath& filter)
{
  vtkObject::GlobalWarningDisplayOff();
  filter.Update();
  vtkObject::GlobalWarningDisplayOn();
  const palpate::PathReport& report = filter.GetReport();
  const std::string& problem = report.refusal;
  if (!problem.empty() || !report.unfelt.empty())
  {
    throw vtkHapticCliProblem(
      !problem.empty() ? options.Settings.Said(problem) : "the field had no effect: " + report.unfelt);
  }
  for (const std::vector<std::string>* notes : { &report.remarks, &report.notes })
  {
    std::ranges::for_each(*notes, [&](const std::string& note) { vtkHapticCliNote("", options.Settings.Said(note)); });
  }
}
} // namespace

int vtkHapticCliTouch(const vtkHapticCliTouchOptions& options)
{
  CheckKinds(options, vtkHapticIsMechanismFile(options.Files.front()));
  CheckLooseOnce(options);
  CheckPlaneAlone(options);
  palpate::SettingStore felt = options.Settings.Store();
  vtkNew<vtkTouchAlongPath> filter;
  vtkHapticCliSetField(options.Field, options.Settings, options.Iso, felt, *filter);
  felt.put("LinesAsWalls", static_cast<double>(options.TwoD ? palpate::AutoChoice::On : palpate::AutoChoice::Auto));
  felt.put("ToolCoupling", options.VirtualCoupling ? 1.0 : 0.0);
  const std::vector<palpate::PathSample> path = vtkHapticCliReadPath(options.Path, !options.Tool.empty());
  if (options.TwoD)
  {
    vtkHapticCliCheckPlanePath(options.Path, path);
  }
  std::vector<std::string> inputs = options.Files;
  inputs.insert(inputs.end(), options.Field.Surfaces.begin(), options.Field.Surfaces.end());
  inputs.insert(inputs.end(), { options.Field.OtherFile, options.Path, options.Tool, options.Loose });
  AddFiles(options, felt, *filter);
  filter->SetSettings(felt);
  filter->AddNamed(1, options.Path, DataOf(path));
  filter->SetTimeArray("t");
  filter->SetTurnArray("q");
  filter->WithCostOn();
  vtkHapticCliOutput output(options.Output, inputs);
  Run(options, *filter);
  Write(*filter->GetOutput(), output);
  output.Commit();
  return 0;
}
