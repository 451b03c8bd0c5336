// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticConversionAhead_h
#define vtkHapticConversionAhead_h

#include <cstddef>
#include <cstdint>
#include <future>
#include <map>
#include <optional>
#include <vector>

#include "vtkHapticConversion.h"
#include "vtkHapticPipelineModule.h" // for the export macro

/// A copy that shares the arrays; the pipeline can execute again without changing it, blocks included.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkDataObject> vtkHapticSharedCopy(vtkDataObject* data);

/**
 * Polygons of large data are turned into triangles by threads, before the mesh is asked for: a million of them would
 * hold the caller's thread for a quarter of a second.
 *
 * A thread reads a copy that shares the arrays. VTK's filters make new arrays with each execution; what is changed in
 * place all the same has another key then, and what was made of it is never given out. One thread calls every method.
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticConversionAhead
{
public:
  /// With fewer cells the caller's thread is not held for longer than a picture takes.
  static constexpr vtkIdType LeastCells = 100000;
  /// That read at once.
  static constexpr std::ptrdiff_t Threads = 2;

  /// Whether there is nothing to wait for: the data are small, or were turned into triangles. Else a thread begins with
  /// it, once, as soon as fewer than Threads are at work. `known` as in vtkHapticToMesh().
  bool Ready(vtkDataObject* data, vtkMatrix4x4* matrix, const vtkHapticCuts* known);
  /// What was made of these data at that place, and done; nothing if it was not. Several sources may have the same.
  std::optional<vtkHapticConversionResult> Take(vtkDataObject* data, vtkMatrix4x4* matrix);
  /// Whether something was begun since Forget().
  bool Busy() const;
  /// What was made is not wanted any more.
  void Forget();

private:
  using Future = std::shared_future<vtkHapticConversionResult>;
  std::map<std::uint64_t, Future> Made; ///< by content and place
  std::vector<Future> Left;             ///< of threads that are at what is not wanted any more
};

#endif
