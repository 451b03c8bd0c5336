// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSceneWorker_h
#define vtkHapticSceneWorker_h

#include <array>
#include <future>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/geometry/scene/SceneSimplifier.h"
#include "vtkHapticConversion.h"
#include "vtkHapticMaterialArrays.h"
#include "vtkHapticSurfacePlacement.h"

class vtkDataObject;
class vtkMatrix4x4;

/// A scene as the worker built it.
struct vtkHapticBuiltScene
{
  std::shared_ptr<const palpate::Scene> Scene; ///< null when nothing is touchable
  std::string Report;                          ///< a line a surface: what was repaired, refused and planned
  std::array<double, 6> Bounds{};              ///< of what is touchable: low and high x, y, z [u]
  double LargestRadius_u = std::numeric_limits<double>::infinity(); ///< whose work fits into a tick
  std::optional<palpate::Pose> Plane_WP; ///< of the walls, where all that is touchable stands across one plane
  palpate::SurfaceTraits Traits;         ///< of the surfaces of the scene
  double Stamp = 0.0;                    ///< of the commit [s]
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
  /// Radius of the tubes as which lines that are added from now on are touched [u]; 0: they are not.
  void SetLineRadius(double radius_u);
  /// Whether lines that are added from now on and lie in a plane are walls across it, for balls up to that radius [u].
  void SetPlaneWorld(bool on, double radius_u);
  /// Converts at once (the pipeline may change its data later). Empty, or why there is nothing to touch. The first
  /// matrix is baked into the vertices; while later ones differ from it by a rigid motion, that is the surface's pose.
  std::string Add(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix);
  /// Another matrix for a surface that was added since Clear(). Empty, or why it stays where it is.
  std::string Place(const std::string& name, vtkMatrix4x4* matrix);
  /// Builds what was added since Clear(). While a build is running the newest commit waits for it; one that only moves
  /// surfaces is done at once. `stamp_s`: when it was so, on the caller's clock.
  void Commit(double stamp_s = 0.0);
  /// Bakes the poses of what was committed into the vertices and commits that, with trees that have no room for ways:
  /// it costs less to touch.
  void Settle();
  /// What is felt now, from where vertices of the next builds come; null: from nowhere. The commit that waits begins:
  /// commits may come faster than builds for as long as they like, and each build is felt and followed by the next.
  void Follow(std::shared_ptr<const palpate::Scene> felt);

  /// The newest scene that is done, once. A commit that waits begins with Follow().
  std::optional<vtkHapticBuiltScene> Poll();
  /// The scene of the newest commit, waiting for it. Nothing if no commit is open.
  std::optional<vtkHapticBuiltScene> Wait();
  /// For a scene that is made from one of the worker's.
  std::uint64_t TakeRevision();

private:
  struct Kept
  {
    std::uint64_t Key = 0;
    std::string Name; ///< it was added by: its triangles and its lines are two surfaces
    palpate::SurfaceInput Input;
    std::optional<palpate::Pose> Plane_WP;                     ///< its triangles are walls across that plane, as baked
    double WallRadius_u = 0.0;                                 ///< for balls up to this radius
    vtkHapticPlacement Baked = vtkHapticPlacement::Identity(); ///< what the vertices were placed by
    vtkHapticCuts Cuts;                                        ///< of the polygons it came from
    std::vector<std::size_t> PartPoints;
    std::uint64_t ArraysKey = 0; ///< of the arrays Input.fields came from
    vtkHapticMaterialSettings Settings;
    std::string MaterialNote;
  };

  /// How the polygons of what was committed under that name were cut; null: there is no such surface.
  [[nodiscard]] const vtkHapticCuts* CutsOf(const std::string& name) const;
  void Launch();
  void Resume();
  /// Triangles, or with a radius lines. Empty, or why there are none.
  std::string AddPart(
    const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix, std::optional<double> lineRadius_u);
  /// Lines as walls. Empty, or why they are none.
  std::string AddWalls(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix);
  void NoteWithoutArrays(Kept& walls) const;
  /// The plane of all that was committed.
  std::optional<palpate::Pose> CommittedPlane() const;
  bool AddKnown(const std::string& name, std::uint64_t key, const vtkHapticPlacement& placement,
    std::optional<double> lineRadius_u);
  /// Gives a surface whose points are new the frame that it was in when it was committed, if its triangles are the same
  /// and a rigid motion leads from there to where it is: then it goes on bending in that frame while that moves.
  void KeepFrame(Kept& kept) const;
  static void MoveTo(Kept& kept, const vtkHapticPlacement& placement);
  /// Moves the vertices to where `placement` has them.
  static void Bake(Kept& kept, const vtkHapticPlacement& placement);

  void ReadMaterial(vtkDataObject* data, Kept& kept) const;

  vtkHapticMaterialSettings Materials;
  double LineRadius_u = 0.0;
  bool PlaneWorld = false;
  double WallRadius_u = 0.0;
  std::vector<Kept> Adding;
  std::string Refusals; ///< since Clear(), a line each
  bool Editing = false; ///< something was added or moved since Commit()
  std::vector<Kept> Committed;
  std::string CommittedRefusals;
  double Stamp = 0.0;
  palpate::SceneBuilder Builder{ 2 };
  std::shared_ptr<const palpate::Scene> Felt;
  std::future<vtkHapticBuiltScene> Running;
  double LargestRadius_u = std::numeric_limits<double>::infinity(); ///< of the last scene that was not only moved
  bool Again = false;                                               ///< there was another commit while building
};

#endif
