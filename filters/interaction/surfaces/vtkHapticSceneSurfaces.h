// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSceneSurfaces_h
#define vtkHapticSceneSurfaces_h

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "haptics/session/scene/SceneWorker.h"
#include "vtkDataObject.h"
#include "vtkHapticConversion.h"
#include "vtkHapticConversionAhead.h"
#include "vtkHapticMaterialArrays.h"
#include "vtkHapticSourceStyles.h"
#include "vtkHapticSurfacePlacement.h"
#include "vtkSmartPointer.h"

class vtkMatrix4x4;

/// The surfaces of a scene, from VTK data: put together, placed, and handed to the worker that builds the scene.
class vtkHapticSceneSurfaces
{
public:
  void Clear();
  /// Arrays for the material of surfaces that are added from now on.
  void SetMaterials(const vtkHapticMaterialSettings& settings);
  /// Radius of the tubes as which lines that are added from now on are touched [u]; 0: they are not.
  void SetLineRadius(double radius_u);
  /// Radius of the balls as which points that are added from now on are touched [u]; 0: they are not.
  void SetPointRadius(double radius_u);
  /// Whether lines that are added from now on and lie in a plane are walls across it, for balls up to that radius [u].
  void SetPlaneWorld(bool on, double radius_u);
  /// Which part of a whole that is too large to be here surfaces are that are added from now on, by number; 0: wholes.
  /// Parts are never taken for one another, whatever their triangles are.
  void SetPartNumber(int number) { this->PartNumber = number; }
  /// How much of their wholes there is, with the next commit.
  void SetPart(const palpate::ScenePart& part) { this->ScenePart = part; }
  /// How a source that is added under `name` from now on is touched; it is as long as it is not said otherwise.
  [[nodiscard]] vtkHapticSourceStyles& Styles() { return this->OfSources; }
  [[nodiscard]] const vtkHapticSourceStyles& Styles() const { return this->OfSources; }
  /// Converts at once (the pipeline may change its data later). Empty, or why there is nothing to touch. The first
  /// matrix is baked into the vertices; while later ones differ from it by a rigid motion, that is the surface's pose.
  std::string Add(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix);
  /// Whether Add() has nothing to convert that would hold the caller's thread for longer than a picture takes; else a
  /// thread begins with it.
  bool Prepare(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix);
  /// Whether it began so, and Add() was not called since; and that it will not be.
  [[nodiscard]] bool Preparing() const { return this->Ahead.Busy(); }
  void ForgetPrepared() { this->Ahead.Forget(); }
  /// Gives up a commit that is not built, or only begun: the scene taken last counts as committed again.
  void Cancel(palpate::SceneWorker& worker)
  {
    this->Ahead.Forget();
    worker.cancel();
    this->Committed = this->Taken;
  }
  /// The scene that the worker has given is the committed one, if nothing came after that.
  void Took(const palpate::SceneWorker& worker) { this->Taken = worker.building() ? this->Taken : this->Committed; }
  /// Another matrix for a surface that was added since Clear(). Empty, or why it stays where it is.
  std::string Place(const std::string& name, vtkMatrix4x4* matrix);
  /// Has the worker build the surfaces that were added since Clear(). `stamp_s`: when they were, on the caller's clock.
  void Commit(palpate::SceneWorker& worker, double stamp_s = 0.0);
  /// Bakes the poses of the committed surfaces into the vertices and commits those, with trees without memory for
  /// motions: they cost less to touch. Not while something is being put together or built.
  void Settle(palpate::SceneWorker& worker);

  /// Where a surface of the scene that was committed comes from.
  struct Origin
  {
    std::string Name;             ///< by which the data was added
    vtkDataObject* Data;          ///< as it was added
    vtkHapticPlacement Placement; ///< from the frame of the data to where the surface is, or goes
  };
  /// By the surface's own name, which for lines and walls says so; nothing if there is none of that name.
  [[nodiscard]] std::optional<Origin> OriginOf(const std::string& surface) const;
  /// By the name it was added by.
  [[nodiscard]] std::optional<Origin> SourceNamed(const std::string& name) const;
  /// A line for each array that a material is to come from and that nothing in the committed scene has.
  [[nodiscard]] std::string MissingArrays() const;
  /// How many scenes were committed so far.
  [[nodiscard]] std::uint64_t Commits() const { return this->CommitCount; }

private:
  struct Kept
  {
    std::uint64_t Key = 0;
    std::string Name;                    ///< it was added by: its triangles and its lines are two surfaces
    vtkSmartPointer<vtkDataObject> Data; ///< a copy that shares the arrays
    palpate::SceneSurface Surface;
    double WallRadius_u = 0.0;                                 ///< for balls up to this radius
    vtkHapticPlacement Baked = vtkHapticPlacement::Identity(); ///< pose of the vertices
    vtkHapticCuts Cuts;                                        ///< of the polygons it came from
    std::vector<std::size_t> PartPoints;
    bool Balls = false;          ///< points of the data, not polygons or lines
    std::uint64_t ArraysKey = 0; ///< of the arrays that the fields came from
    vtkHapticMaterialSettings Settings;
  };

  [[nodiscard]] std::optional<Origin> OriginWhere(const std::function<bool(const Kept&)>& sought) const;
  /// How the polygons of the surface that was committed under that name were cut; null: there is no such surface.
  [[nodiscard]] const vtkHapticCuts* CutsOf(const std::string& name) const;
  /// All that can be touched of a data object. Empty, or why there is nothing.
  std::string AddParts(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix);
  /// Triangles, or with a radius lines. Empty, or why there are none.
  std::string AddPart(
    const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix, std::optional<double> lineRadius_u);
  using Part = vtkHapticConversionAhead::Part;
  /// Lines or points, as Read() and a thread read them.
  [[nodiscard]] vtkHapticConversionAhead::Reading ReadingOf(Part part) const;
  /// Data that were read ahead, or are read now.
  vtkHapticConversionResult Read(Part part, vtkDataObject* data, vtkMatrix4x4* matrix);
  vtkHapticConversionResult ReadFaces(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix);
  ///@{
  /// Prepare() for a part of the data.
  bool PrepareFaces(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix);
  bool PrepareLines(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix);
  bool PreparePoints(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix);
  ///@}
  ///@{
  /// A committed surface of the same content; null: none.
  [[nodiscard]] const Kept* FindCommitted(const std::function<bool(const Kept&)>& sought) const;
  [[nodiscard]] const Kept* FindBalls(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix) const;
  [[nodiscard]] const Kept* FindWalls(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix) const;
  ///@}
  /// Points as balls. Empty, or why there are none.
  std::string AddBalls(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix);
  /// Lines as walls. Empty, or why they are none.
  std::string AddLinesAndFaces(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix);
  std::string AddWalls(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix);
  void NoteWithoutArrays(Kept& walls) const;
  /// A committed surface of that content, and its pose; null without one.
  std::pair<const Kept*, palpate::Pose> FindKnown(const std::string& name, std::uint64_t key,
    const vtkHapticPlacement& placement, std::optional<double> lineRadius_u) const;
  bool AddKnown(const std::string& name, std::uint64_t key, const vtkHapticPlacement& placement,
    std::optional<double> lineRadius_u);
  /// A surface with new points keeps the frame that it was committed in if its triangles are the same and the motion
  /// from there is rigid. The surface then bends in that frame while the frame moves.
  void KeepFrame(Kept& kept) const;
  static void MoveTo(Kept& kept, const vtkHapticPlacement& placement);
  /// Moves the vertices to where `placement` has them.
  static void Bake(Kept& kept, const vtkHapticPlacement& placement);

  void ReadMaterial(vtkDataObject* data, Kept& kept) const;

  vtkHapticSourceStyles OfSources;
  vtkHapticMaterialSettings Materials;
  double LineRadius_u = 0.0;
  double PointRadius_u = 0.0;
  bool PlaneWorld = false;
  double WallRadius_u = 0.0;
  int PartNumber = 0;
  palpate::ScenePart ScenePart;
  vtkHapticConversionAhead Ahead;
  std::vector<Kept> Adding;
  std::string Refusals; ///< since Clear(), a line each
  bool Editing = false; ///< something was added or moved since Commit()
  std::vector<Kept> Committed;
  std::vector<Kept> Taken; ///< as committed when the worker had built it
  double Stamp = 0.0;      ///< of the commit [s]
  std::uint64_t CommitCount = 0;
};

#endif
