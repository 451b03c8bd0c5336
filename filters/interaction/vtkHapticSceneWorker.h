// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSceneWorker_h
#define vtkHapticSceneWorker_h

#include <array>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/geometry/SceneBuilder.h"
#include "vtkHapticMaterialArrays.h"

class vtkDataObject;
class vtkMatrix4x4;

/// A scene as the worker built it.
struct vtkHapticBuiltScene
{
  std::shared_ptr<const palpate::Scene> Scene; ///< null when nothing is touchable
  std::string Report;                          ///< a line a surface: what was repaired, refused and planned
  std::array<double, 6> Bounds{};              ///< of what is touchable: low and high x, y, z [u]
};

/// Turns VTK surfaces into scenes, off the caller's thread. One thread calls every method.
class vtkHapticSceneWorker
{
public:
  /// Waits for the worker.
  ~vtkHapticSceneWorker();

  void Clear();
  /// Which arrays say what the surfaces that are added from now on are made of.
  void SetMaterials(const vtkHapticMaterialSettings& settings);
  /// Converts at once (the pipeline may change its data later). Empty, or why there is nothing to touch.
  std::string Add(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix);
  /// Builds what was added since Clear(). While a build is running the newest commit waits for it.
  void Commit();

  /// The newest scene, once, when it is done; nothing else.
  std::optional<vtkHapticBuiltScene> Poll();
  /// The same, waiting for it. Nothing if no commit is open.
  std::optional<vtkHapticBuiltScene> Wait();

private:
  struct Kept
  {
    std::uint64_t Key;
    palpate::SurfaceInput Input;
    std::vector<std::size_t> PartPoints;
    std::uint64_t ArraysKey = 0; ///< of the arrays Input.fields came from
    vtkHapticMaterialSettings Settings;
    std::string MaterialNote;
  };

  void Launch();

  void ReadMaterial(vtkDataObject* data, Kept& kept) const;

  vtkHapticMaterialSettings Materials;
  std::vector<Kept> Adding;
  std::vector<Kept> Committed;
  palpate::SceneBuilder Builder{ 2 };
  std::future<vtkHapticBuiltScene> Running;
  bool Again = false; ///< there was another commit while building
};

#endif
