// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticNIfTIReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <stdexcept>
#include <vector>

#include "vtkDataObject.h"
#include "vtkHapticFileGuards.h"
#include "vtkHapticNIfTIImage.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkHapticNIfTIReader);

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

/// An exception of `read` becomes one line with the file's name; empty when all went well.
template<class Read>
std::string ProblemOf(const char* file, Read read)
{
  try
  {
    read();
    return {};
  }
  catch (const std::bad_alloc&)
  {
    return std::string(file) + ": not enough memory to read the file";
  }
  catch (const std::exception& error)
  {
    return std::string(file) + ": " + error.what();
  }
}

void TellPlace(vtkInformation* info, const vtkHapticNIfTIHeader& header)
{
  const std::array<int, 6> extent = { 0, header.Size[0] - 1, 0, header.Size[1] - 1, 0, header.Size[2] - 1 };
  info->Set(Pipeline::WHOLE_EXTENT(), extent.data(), 6);
  vtkNew<vtkImageData> placed;
  vtkHapticNIfTIImage::Place(header, placed);
  info->Set(vtkDataObject::ORIGIN(), placed->GetOrigin(), 3);
  info->Set(vtkDataObject::SPACING(), placed->GetSpacing(), 3);
  info->Set(vtkDataObject::DIRECTION(), placed->GetDirectionMatrix()->GetData(), 9);
  vtkDataObject::SetPointDataActiveScalarInfo(
    info, vtkHapticNIfTIImage::ScalarTypeOf(header), header.NumbersPerVoxel());
}

void TellTimes(vtkInformation* info, const vtkHapticNIfTIHeader& header)
{
  if (header.TimeSteps == 1)
  {
    info->Remove(Pipeline::TIME_STEPS());
    info->Remove(Pipeline::TIME_RANGE());
    return;
  }
  std::vector<double> times;
  for (std::int64_t step = 0; step < header.TimeSteps; ++step)
  {
    times.push_back(header.FirstTime_s + static_cast<double>(step) * header.TimeStep_s);
  }
  const std::array<double, 2> range = { times.front(), times.back() };
  info->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  info->Set(Pipeline::TIME_RANGE(), range.data(), 2);
}

/// The last step that is not after the time asked for.
std::int64_t StepFor(vtkInformation* info, const vtkHapticNIfTIHeader& header)
{
  if (!info->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    return 0;
  }
  constexpr double rounding = 1e-6; // of a step: times are sums
  const double steps = (info->Get(Pipeline::UPDATE_TIME_STEP()) - header.FirstTime_s) / header.TimeStep_s;
  const auto last = static_cast<double>(header.TimeSteps - 1);
  return static_cast<std::int64_t>(std::clamp(std::floor(steps + rounding), 0.0, last));
}
} // namespace

vtkHapticNIfTIReader::vtkHapticNIfTIReader() : Header(std::make_unique<vtkHapticNIfTIHeader>())
{
  this->SetNumberOfInputPorts(0);
}

vtkHapticNIfTIReader::~vtkHapticNIfTIReader()
{
  this->SetFileName(nullptr);
}

int vtkHapticNIfTIReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  if (!this->FileName)
  {
    vtkErrorMacro("A file name is needed");
    return 0;
  }
  const std::string problem = ProblemOf(this->FileName,
    [this]
    {
      vtkHapticFileGuards::ThrowIf(vtkHapticFileGuards::CheckFile(this->FileName));
      *this->Header = vtkHapticNIfTIImage::ReadHeader(this->FileName);
    });
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  TellPlace(output->GetInformationObject(0), *this->Header);
  TellTimes(output->GetInformationObject(0), *this->Header);
  return 1;
}

int vtkHapticNIfTIReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* const info = output->GetInformationObject(0);
  const std::int64_t step = StepFor(info, *this->Header);
  const std::string problem = ProblemOf(this->FileName,
    [&]
    {
      vtkImageData* const image = vtkImageData::GetData(output);
      image->ShallowCopy(vtkHapticNIfTIImage::Read(this->FileName, *this->Header, step));
      image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
        this->Header->FirstTime_s + static_cast<double>(step) * this->Header->TimeStep_s);
    });
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  return 1;
}

void vtkHapticNIfTIReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
}
