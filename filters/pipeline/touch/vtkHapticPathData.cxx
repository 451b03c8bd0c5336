// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPathData.h"

#include "vtkHapticConversion.h"

namespace
{
vtkHapticTransfer TransferOf(const palpate::SettingStore& settings, const std::string& quantity)
{
  const auto range = [&](const char* name)
  {
    const std::vector<double>& ends = settings.of(quantity + name).numbers;
    return std::array<double, 2>{ ends.at(0), ends.at(1) };
  };
  return { settings.text(quantity + "Array"), settings.whole(quantity + "Component"), range("DataRange"),
    range("FeltRange") };
}
} // namespace

vtkHapticMaterialSettings vtkHapticMaterialsOf(const palpate::SettingStore& settings)
{
  return { TransferOf(settings, "Stiffness"), TransferOf(settings, "Friction"), TransferOf(settings, "Texture") };
}

vtkHapticFieldArrays vtkHapticFieldArraysOf(const palpate::SettingStore& settings)
{
  vtkHapticFieldArrays arrays;
  arrays.Scalar = settings.text("FieldArray");
  arrays.Vector = settings.text("FieldVectors");
  arrays.Resistance = settings.text("FieldResistance");
  arrays.Other = settings.text("FieldOther");
  arrays.Component = settings.whole("FieldComponent");
  arrays.Eigenvector = settings.whole("FieldEigenvector");
  arrays.Smoothing = settings.whole("FieldSmoothing");
  return arrays;
}

std::vector<palpate::PathSurface> vtkHapticToPathSurfaces(vtkDataObject& data, const std::string& name,
  const vtkHapticMaterialSettings& materials, bool curves, std::string& problem)
{
  std::vector<palpate::PathSurface> surfaces;
  const auto add = [&](const vtkHapticConversionResult& read, bool isCurves)
  {
    const vtkHapticMaterialResult material = vtkHapticToMaterial(&data, read.PartPoints, materials);
    surfaces.push_back({ name, read.Mesh, material.Fields, isCurves, read.HoleEdges, material.Note, material.Problem });
  };
  const vtkHapticConversionResult faces = vtkHapticToMesh(&data);
  if (faces.Mesh)
  {
    add(faces, false);
  }
  const vtkHapticConversionResult lines = curves ? vtkHapticToLines(&data) : vtkHapticConversionResult{};
  if (lines.Mesh)
  {
    add(lines, true);
  }
  problem = surfaces.empty() ? faces.Problem : "";
  return surfaces;
}

void vtkHapticAddLoose(
  vtkDataObject& data, const std::string& name, double density, palpate::PathInputs& inputs, std::string& problem)
{
  constexpr double heaviest = 1e6;
  const vtkHapticConversionResult made = vtkHapticToMesh(&data);
  const bool dense = density > 0.0 && density <= heaviest;
  problem = !dense      ? name + ": cannot be loose: its density must be above 0 and at most 1e6 kg/m3"
            : made.Mesh ? ""
                        : name + ": cannot be loose: " + made.Problem;
  if (problem.empty())
  {
    inputs.surfaces.push_back({ name, made.Mesh });
    inputs.surfaces.back().density_kg_per_m3 = density;
  }
}
