// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticConversionAhead_h
#define vtkHapticConversionAhead_h

#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <optional>
#include <vector>

#include "vtkHapticConversion.h"
#include "vtkHapticPipelineModule.h" // for the export macro

/// A copy that shares the arrays; the pipeline can execute again without changing it, blocks included.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkDataObject> vtkHapticSharedCopy(vtkDataObject* data);

/**
 * Large data are turned into triangles and segments by threads, before the mesh is asked for: a million polygons would
 * hold the caller's thread for a quarter of a second.
 *
 * A thread reads a copy that shares the arrays. VTK's filters make new arrays with each execution; data that are
 * changed in place all the same have another key then, and their conversion is never given out. One thread calls every
 * method.
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticConversionAhead
{
public:
  /// The part of the data that is read.
  enum class Part : std::uint8_t
  {
    Faces,
    Lines,
    Points,
  };
  using Reading = std::function<vtkHapticConversionResult(vtkDataObject*, vtkMatrix4x4*)>;

  /// With fewer cells, and fewer points, the caller's thread does not wait for longer than a picture takes.
  static constexpr vtkIdType LeastCells = 100000;
  /// That read at once.
  static constexpr std::ptrdiff_t Threads = 2;

  /// Whether there is nothing to wait for: the data are small, or that part of them was read. Else a thread begins with
  /// `read`, once, as soon as fewer than Threads are at work. A part is read in one way until Forget().
  bool Ready(Part part, vtkDataObject* data, vtkMatrix4x4* matrix, const Reading& read);
  /// The finished result for that part at that pose; nothing if unfinished. Several sources may have the same.
  std::optional<vtkHapticConversionResult> Take(Part part, vtkDataObject* data, vtkMatrix4x4* matrix);
  /// Whether something was begun since Forget().
  bool Busy() const;
  /// Discards the results.
  void Forget();

private:
  using Future = std::shared_future<vtkHapticConversionResult>;
  std::map<std::uint64_t, Future> Made; ///< by content and place
  std::vector<Future> Left;             ///< of threads that work on discarded results
};

#endif
