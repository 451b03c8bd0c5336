// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticRemoteSurfaces_h
#define vtkHapticRemoteSurfaces_h

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "vtkHapticRemoteSurface.h"
#include "vtkHapticShape.h"

class vtkHapticSession;
class vtkMatrix4x4;
class vtkObject;

/// The surfaces that a view of a server shows, fetched as far as a session touches them.
class vtkHapticRemoteSurfaces
{
public:
  /// Whether the data of a representation are fetched: polygons of its source, drawn as they are.
  [[nodiscard]] static bool Fetches(vtkObject* active);

  /// Fetches the changed ones of the visible surfaces, and of those that are too large to be whole the part around the
  /// hand once that is near the rim of the last part. Waits for the server; nothing is fetched where nothing is needed.
  void Follow(vtkSMProxy* view, vtkHapticSession* session);
  /// Tells a session how much of them the scene has that it gets now.
  void Tell(vtkHapticSession& session) const;

  /// The fetched data of one; without data and problem: it was not asked for yet.
  [[nodiscard]] vtkHapticShape ShapeOf(vtkSMProxy* representation) const;
  /// Number of its part; 0: it is whole.
  [[nodiscard]] int PartOf(vtkSMProxy* representation) const;

private:
  struct Shown
  {
    std::string Name;
    vtkSmartPointer<vtkMatrix4x4> Matrix; ///< of the data to W
    std::unique_ptr<vtkHapticRemoteSurface> Surface;
  };

  /// Keeps those that are visible, and begins with those that are new.
  void Keep(vtkSMProxy* view, vtkHapticSession& session);
  /// Takes the entry of before, where it shows the same.
  void Add(vtkSMProxy* representation, vtkHapticSession& session, std::map<vtkSMProxy*, Shown>& before);
  [[nodiscard]] static vtkHapticPartWish WishOf(const Shown& shown, vtkSMProxy* view, vtkHapticSession& session);

  std::map<vtkSMProxy*, Shown> All; ///< by representation
};

#endif
