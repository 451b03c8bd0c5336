// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticWire.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "vtkDataObject.h"
#include "vtkHapticConversion.h"
#include "vtkHapticJson.h"
#include "vtkHapticMechanismFile.h"
#include "vtkHapticVesselMiddle.h"
#include "vtkHapticWholeInput.h"
#include "vtkHapticWireFile.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLPolyDataWriter.h"

vtkStandardNewMacro(vtkHapticWire);

namespace
{
using palpate::Vec3;
using Ordered = nlohmann::ordered_json;

struct Assumed
{
  const char* Name;
  double Young_Pa;
};
/// Nitinol in its austenite phase, stainless steel 304, nylon 6: handbook values, rounded.
constexpr std::array<Assumed, vtkHapticWire::OTHER> Assumptions{ { { "NiTi", 6e10 }, { "steel", 1.9e11 },
  { "nylon", 2.5e9 } } };

Ordered PointOf(const double p[3])
{
  return Ordered{ p[0], p[1], p[2] };
}

void AddUnless(double without, Ordered& wire, const char* key, double value)
{
  if (value != without) // not a number is refused where the text is read
  {
    wire[key] = value;
  }
}
} // namespace

vtkHapticWire::vtkHapticWire()
{
  this->SetNumberOfInputPorts(1);
  this->Refusal = "The wire cannot be made: ";
}

vtkHapticWire::~vtkHapticWire() = default;

void vtkHapticWire::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scene: " << this->Describe("", this->Mouth) << '\n';
  os << indent << "SceneFile: " << this->SceneFile << '\n';
}

int vtkHapticWire::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

void vtkHapticWire::TakeVessel(vtkDataObject* vessel)
{
  const vtkHapticConversionResult converted = vtkHapticToMesh(vtkHapticWholeSurface(vessel));
  this->Wall = converted.Mesh ? vtkHapticToPolyData(*converted.Mesh) : nullptr;
  this->NoWall = converted.Problem;
}

void vtkHapticWire::PlaceMouth()
{
  const Vec3 mouth_W(this->Mouth);
  const bool centred = this->Centred && this->Wall;
  Eigen::Map<Vec3>{ this->Placed } =
    centred ? vtkHapticVesselMiddle(*this->Wall, mouth_W, Vec3(this->Ahead) - mouth_W) : mouth_W;
}

std::string vtkHapticWire::Describe(const std::string& vessel, const double mouth[3]) const
{
  Ordered wire{ { "name", "wire" }, { "kind", "wire" } };
  if (!vessel.empty())
  {
    wire["vessel"] = vessel;
  }
  wire["diameter"] = this->Diameter;
  wire["length"] = this->Length;
  wire["young_Pa"] =
    this->Material == OTHER ? this->Young : Assumptions.at(static_cast<std::size_t>(this->Material)).Young_Pa;
  wire["poisson"] = this->Poisson;
  wire["friction"] = this->Friction;
  const Vec3 direction_W = Vec3(this->Ahead) - Vec3(this->Mouth);
  wire["mouth"] = PointOf(mouth);
  wire["direction"] = PointOf(direction_W.data());
  wire["tip"] = vtkHapticWireTips.at(static_cast<std::size_t>(this->Tip));
  AddUnless(0.0, wire, "tip_length", this->TipLength);
  AddUnless(0.0, wire, "tip_radius", this->TipRadius);
  AddUnless(0.0, wire, "tip_pitch", this->TipPitch);
  AddUnless(0.0, wire, "tip_young_Pa", this->TipYoung);
  AddUnless(0.0, wire, "beams", this->Beams);
  const Ordered scene{ { "format", vtkHapticSceneFormat }, { "version", vtkHapticSceneVersion },
    { "unit_m", this->Unit }, { "bodies", Ordered::array({ wire }) } };
  return scene.dump(2) + "\n";
}

vtkHapticMechanismResult vtkHapticWire::ReadScene()
{
  if (!this->Wall)
  {
    vtkHapticMechanismResult none;
    none.Problem = "the input cannot be its vessel: " + this->NoWall;
    return none;
  }
  vtkHapticMechanismResult read =
    vtkHapticParseMechanism(this->Describe("", this->Placed), "", "", {}, vtkHapticToMesh(this->Wall).Mesh);
  if (this->Material != OTHER)
  {
    const Assumed& assumed = Assumptions.at(static_cast<std::size_t>(this->Material));
    std::ostringstream said;
    said << "Young's modulus " << assumed.Young_Pa << " Pa is assumed for " << assumed.Name << '\n';
    this->Text = said.str();
  }
  if (this->Centred)
  {
    const bool moved = !std::equal(this->Placed, this->Placed + 3, this->Mouth);
    std::ostringstream said;
    said << "the sheath ends at (" << this->Placed[0] << ", " << this->Placed[1] << ", " << this->Placed[2] << ") u, "
         << (moved ? "in the middle of the vessel" : "where Mouth is") << "\n";
    this->Text += said.str();
  }
  return read;
}

std::string vtkHapticWire::Write() const
{
  const std::filesystem::path file(this->SceneFile);
  std::filesystem::path vessel = file;
  vessel.replace_extension();
  vessel += "-vessel.vtp";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(vessel.string().c_str());
  writer->SetInputData(this->Wall);
  const std::string advice = " cannot be written: choose a folder that is there and can be written to";
  std::error_code error;
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder, error) || writer->Write() != 1)
  {
    return vessel.string() + advice;
  }
  std::ofstream stream(file, std::ios::binary);
  stream << this->Describe(vessel.filename().string(), this->Placed);
  stream.close();
  return stream ? "" : file.string() + advice;
}

int vtkHapticWire::RequestData(vtkInformation* info, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkDataObject* const given = vtkDataObject::GetData(input[0]);
  const vtkMTimeType time = given ? given->GetMTime() : 0;
  const bool other = time != this->VesselTime;
  if (other)
  {
    this->VesselTime = time;
    this->TakeVessel(given);
  }
  const std::string wanted = this->Describe("", this->Mouth) + (this->Centred ? "centred" : "") + this->SceneFile;
  const bool anew = other || wanted != this->Made;
  if (anew)
  {
    this->Made = wanted;
    this->PlaceMouth();
    this->AskAgain();
  }
  const bool made = this->Superclass::RequestData(info, input, output) == 1 && *this->GetProblem() == '\0';
  const std::string problem = anew && made && !this->SceneFile.empty() ? this->Write() : "";
  if (!problem.empty())
  {
    vtkErrorMacro("The scene file of the wire: " << problem);
  }
  return 1;
}
