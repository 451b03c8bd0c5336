// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticMechanismData_h
#define vtkHapticMechanismData_h

#include <string>
#include <vector>

#include "vtkHapticMechanismFile.h"
#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkPolyData;

/// Arrays of the surfaces of a mechanism's bodies.
struct vtkHapticMechanismArray
{
  static constexpr const char* Body = "Body";                 ///< (1) of cells and points: which one, by its place
  static constexpr const char* Vertex = "Vertex";             ///< (1) of points: which one of a soft body; else -1
  static constexpr const char* Displacement = "Displacement"; ///< (3) of points: how far nodes of soft bodies went [u]
  static constexpr const char* Dent = "Dent";                 ///< (3) of points: how much further they are shown [u]
};

/// The surfaces of a mechanism's bodies as they are at first: those that are held about the origin.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkPolyData> vtkHapticMechanismShapes(
  const vtkHapticMechanismResult& read);

/// The held body of a mechanism, in its own frame: from the hand along +z.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkPolyData> vtkHapticHeldShape(
  const palpate::MechanismBody& body);

/// Describes a mechanism by the text of its file and the folder of that, as field data.
VTKHAPTICPIPELINE_EXPORT void vtkHapticDescribeMechanism(
  vtkDataObject& data, const std::string& text, const std::string& folder);

/// Describes where the vessel of a wire is: among the cells of the data, and in no file.
VTKHAPTICPIPELINE_EXPORT void vtkHapticDescribeVessel(vtkDataObject& data);

/// Whether data describe a mechanism.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticIsMechanism(vtkDataObject* data);

/// Whether shapes are as large and where their description had them: a Transform passes the description on unchanged.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticIsWhereMade(vtkDataObject& data);

/// The text of the scene file that data describe a mechanism by, and the folder of that; "": they do not.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string vtkHapticMechanismFileOf(vtkDataObject& data);
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string vtkHapticMechanismFolderOf(vtkDataObject& data);

/// Data that were brought from a server: the folder is one of the server's.
VTKHAPTICPIPELINE_EXPORT void vtkHapticSetOfServer(vtkDataObject& data);
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticIsOfServer(vtkDataObject& data);

/// The vessel of a wire whose description names no file of one: those cells of the data. Null: it names one, or the
/// data are no wire.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::shared_ptr<const palpate::TriangleMesh> vtkHapticVesselOf(
  vtkDataObject& data);

/// The mechanism that data describe.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticMechanismResult vtkHapticToMechanism(vtkDataObject& data);

/// Of a loose body.
struct vtkHapticLooseMass
{
  double Mass_kg = 0.0;
  double Density_kg_per_m3 = 0.0;
};
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticLooseMass vtkHapticMassOf(
  const palpate::MechanismBody& body, double unit_m);

/// Properties of a mechanism, a line each.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::vector<std::string> vtkHapticMechanismText(
  const palpate::MechanismInputs& inputs, const palpate::MechanismCheck& check);

#endif
