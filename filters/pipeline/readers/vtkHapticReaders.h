// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticReaders_h
#define vtkHapticReaders_h

#include <optional>
#include <string>

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkPolyData;

/// A surface read from a file, or why there is none.
struct vtkHapticReadResult
{
  vtkSmartPointer<vtkPolyData> Surface; ///< polygons, strips and lines in the file's own coordinates; null on a problem
  std::string Problem;                  ///< one line: file, fault, remedy; empty when Surface can be used
  std::string Note;                     ///< warnings and ignored parts, one line; mostly empty
};

/// Reads vtp, vtu, stl, ply, obj and off, and with an iso value vti, nii and nii.gz, as a surface [scene units]; svg
/// and png as lines in the plane z = 0, with the field arrays Start and Exit (3) double where a drawing is a maze.
///
/// The skin of a volume mesh, the iso surface of an image. An image stands where its header puts it: vti by origin,
/// spacing and direction, NIfTI by its sform or else qform matrix, its values rescaled as its header says, so that
/// `iso` is in the units of the data. Nothing a header promises is believed before the file is found long enough, and
/// every index is checked before a filter sees it. NaN points and degenerate triangles are left to cleaning.
/// VTK's output window is replaced while reading: call from one thread at a time.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticReadResult vtkHapticReadSurface(
  const std::string& path, std::optional<double> iso);

/// Reads the same meshes for their points and lines alone: a vtp without faces will do.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticReadResult vtkHapticReadPlaces(const std::string& path);

/// Numbers in space read from a file, or why there are none.
struct vtkHapticReadVolumeResult
{
  vtkSmartPointer<vtkDataObject> Volume; ///< with all its arrays, in the file's own coordinates; null on a problem
  std::string Problem;                   ///< one line: file, fault, remedy; empty when Volume can be used
  std::string Note;                      ///< warnings and ignored parts, one line; mostly empty
};

/// Reads vti, vtr, vts, vtu, nii, nii.gz and a vtm of the former whole, to be felt as a field, as careful as
/// vtkHapticReadSurface() is. The values of a NIfTI image are its array "NIFTI".
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticReadVolumeResult vtkHapticReadVolume(const std::string& path);

/// True for the formats that vtkHapticReadVolume() reads, by the extension alone.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticIsVolumeFile(const std::string& path);

/// True for the formats of which an iso surface is made, by the extension alone.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticIsImageFile(const std::string& path);

#endif
