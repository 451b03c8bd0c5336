// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticRemoteSurface_h
#define vtkHapticRemoteSurface_h

#include <memory>
#include <string>

#include "haptics/core/Types.h"
#include "vtkHapticSourceWatch.h"
#include "vtkHapticSurfacePart.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

class vtkSMProxy;
class vtkSMSourceProxy;

/// Which part of a surface is wanted.
struct vtkHapticPartWish
{
  palpate::Vec3 Centre = palpate::Vec3::Zero(); ///< in the frame of the data [u]
  double Reach = 0.0;                           ///< [u]
  int Limit = 0;                                ///< most polygons
  double Time = 0.0;                            ///< of the pipeline
};

/// The surface of a source on a server, as ParaView would draw it: all of it, or the part around the hand. The thread
/// of ParaView's proxies alone may ask it.
class vtkHapticRemoteSurface
{
public:
  vtkHapticRemoteSurface(vtkSMSourceProxy* source, unsigned int port);

  /// Whether the source has made something else since it was asked last, or is wanted otherwise; not where the hand is.
  [[nodiscard]] bool IsStale(const vtkHapticPartWish& wish) const;
  /// Asks the server, and waits for its answer.
  void Ask(const vtkHapticPartWish& wish);

  /// Null: it was not asked yet, or GetProblem() says why.
  [[nodiscard]] vtkPolyData* GetData() const { return this->Data; }
  [[nodiscard]] const std::string& GetProblem() const { return this->Problem; }
  [[nodiscard]] const vtkHapticPartInfo& GetInfo() const { return this->Info; }
  /// How often the source has made something else.
  [[nodiscard]] int GetChanges() const { return this->Changes; }
  /// Null: the source is gone.
  [[nodiscard]] vtkSMSourceProxy* GetSource() const { return this->Watch.GetSource(); }
  [[nodiscard]] unsigned int GetPort() const { return this->Port; }

private:
  [[nodiscard]] vtkSmartPointer<vtkPolyData> Fetch(const vtkHapticPartWish& wish);

  vtkHapticSourceWatch Watch;
  unsigned int Port;
  vtkSmartPointer<vtkSMSourceProxy> Surface, Cut; ///< on the server
  vtkSmartPointer<vtkPolyData> Data;
  vtkHapticPartInfo Info;
  vtkHapticPartWish Asked;
  std::string Problem;
  int Number = 0;
  int Changes = 0;
};

#endif
