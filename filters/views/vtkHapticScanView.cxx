// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticScanView.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArrayRange.h"
#include "vtkGeometryRepresentation.h"
#include "vtkGlyph3DMapper.h"
#include "vtkGlyph3DRepresentation.h"
#include "vtkHapticDrafts.h"
#include "vtkHapticMaterialArrays.h"
#include "vtkHapticNamedData.h"
#include "vtkHapticRemoteSurfaces.h"
#include "vtkHapticShapes.h"
#include "vtkImageSliceRepresentation.h"
#include "vtkMapper.h"
#include "vtkPVDataInformation.h"
#include "vtkPVImageSliceMapper.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSourceProxy.h"

namespace
{
using Surface = vtkHapticViewScan::Surface;

void Mix(std::uint64_t& key, std::uint64_t word)
{
  key = (key ^ word) * 0x100000001b3ull;
  key ^= key >> 32;
}

void MixObject(std::uint64_t& key, vtkObject* object)
{
  Mix(key, reinterpret_cast<std::uintptr_t>(object));
  Mix(key, object ? object->GetMTime() : 0);
}

using Also = vtkHapticScanOptions;

bool IsTouchable(vtkPolyData* data, const Also& also)
{
  return data && data->GetNumberOfPoints() > 0 &&
         data->GetNumberOfPolys() + data->GetNumberOfStrips() + (also.Lines ? data->GetNumberOfLines() : 0) +
             (also.Points ? data->GetNumberOfVerts() : 0) >
           0;
}

void MixPiece(std::uint64_t& key, vtkPolyData* data, const Also& also)
{
  if (IsTouchable(data, also))
  {
    MixObject(key, data->GetPoints());
    MixObject(key, data->GetPolys());
    MixObject(key, data->GetStrips());
    MixObject(key, data->GetLines());
    MixObject(key, data->GetVerts());
  }
}

/// 0 if there is no polygon and, if they count, no line and no point.
std::uint64_t GeometryKey(vtkDataObject* shown, const Also& also)
{
  std::uint64_t key = 0;
  auto* composite = vtkCompositeDataSet::SafeDownCast(shown);
  if (!composite)
  {
    MixPiece(key, vtkPolyData::SafeDownCast(shown), also);
    return key;
  }
  auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
  {
    MixPiece(key, vtkPolyData::SafeDownCast(each->GetCurrentDataObject()), also);
  }
  return key;
}

constexpr const char* OnlyOutline = "only the outline or edges are drawn; choose the representation Surface";
constexpr const char* LinesNeedRadius = "drawn as lines; set Radius of lines in the panel to touch the lines as tubes";

/// The cells that are drawn instead of polygons.
struct Drawn
{
  vtkIdType Lines = 0;
  vtkIdType Points = 0;
};

void CountPiece(Drawn& drawn, vtkPolyData* data)
{
  drawn.Lines += data ? data->GetNumberOfLines() : 0;
  drawn.Points += data ? data->GetNumberOfVerts() : 0;
}

Drawn CountDrawn(vtkDataObject* shown)
{
  Drawn drawn;
  auto* composite = vtkCompositeDataSet::SafeDownCast(shown);
  if (!composite)
  {
    CountPiece(drawn, vtkPolyData::SafeDownCast(shown));
    return drawn;
  }
  auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
  {
    CountPiece(drawn, vtkPolyData::SafeDownCast(each->GetCurrentDataObject()));
  }
  return drawn;
}

/// Whether a source gives no point at all, as a reader does that found its file damaged.
bool GivesNothing(vtkSMProxy* representation)
{
  auto* const input = vtkSMSourceProxy::SafeDownCast(vtkHapticInputOf(representation));
  const unsigned int port = vtkSMPropertyHelper(representation, "Input").GetOutputPort();
  return input && input->GetDataInformation(port)->GetNumberOfPoints() == 0;
}

/// The reason of a representation that shows nothing to touch, but for a source that has nothing to show.
std::string ReasonOf(vtkSMProxy* representation, const std::string& otherwise)
{
  return GivesNothing(representation)
           ? "the source has no points: it may be empty at this time, or its file damaged or "
             "cut short; see View > Output Messages"
           : otherwise;
}

/// The remedy depends on the drawn cells: lines can be felt as they are, points become a surface by a filter.
std::string WhyNoPolygons(vtkObject* active, vtkDataObject* shown)
{
  const Drawn drawn = CountDrawn(shown);
  const bool asItIs = active->IsA("vtkOutlineRepresentation") || active->IsA("vtkFeatureEdgesRepresentation");
  if (asItIs)
  {
    return OnlyOutline;
  }
  if (drawn.Lines > 0)
  {
    return LinesNeedRadius;
  }
  if (drawn.Points > 0)
  {
    return "drawn as points; set Radius of points in the panel, or apply the filter Glyph with the type "
           "Sphere and show its result";
  }
  return "no polygons are shown; choose the representation Surface, or apply Extract Surface";
}

std::string WhyNoSurface(vtkObject* active)
{
  if (active && (active->IsA("vtkVolumeRepresentation") || active->IsA("vtkImageVolumeRepresentation") ||
                  active->IsA("vtkUnstructuredGridVolumeRepresentation")))
  {
    return "a volume has no surface; choose it in the pipeline browser and press Touch (while touching: Let Go, then "
           "Touch) for its isosurface, or apply the filter Contour and show its result";
  }
  return "not drawn as a surface; choose the representation Surface";
}

/// A representation's actor, and the geometry to be felt.
struct Seen
{
  vtkPVLODActor* Actor = nullptr; ///< null: no surface
  vtkHapticShape Shape;           ///< without data and problem: there was no picture yet
};

/// ParaView offers no access to the mapper of the glyphs.
struct GlyphAccess : public vtkGlyph3DRepresentation
{
  static vtkGlyph3DMapper* MapperOf(vtkGlyph3DRepresentation& of) { return of.*(&GlyphAccess::GlyphMapper); }
  static vtkPVLODActor* ActorOf(vtkGlyph3DRepresentation& of) { return of.*(&GlyphAccess::GlyphActor); }
};

vtkDataObject* InputOf(vtkMapper* mapper)
{
  return mapper ? mapper->GetInputDataObject(0, 0) : nullptr;
}

Seen SeenGlyphs(vtkGlyph3DRepresentation& glyphs, vtkHapticShapes& shapes)
{
  vtkGlyph3DMapper* const mapper = GlyphAccess::MapperOf(glyphs);
  return { GlyphAccess::ActorOf(glyphs), InputOf(mapper) ? shapes.GlyphsOf(mapper) : vtkHapticShape() };
}

Seen SeenSlice(vtkImageSliceRepresentation& slice, vtkHapticShapes& shapes)
{
  auto* const mapper = vtkPVImageSliceMapper::SafeDownCast(slice.GetActor()->GetMapper());
  return { slice.GetActor(), InputOf(mapper) ? shapes.SliceOf(mapper) : vtkHapticShape() };
}

Seen SeenOf(vtkObject* active, vtkHapticShapes& shapes)
{
  if (auto* glyphs = vtkGlyph3DRepresentation::SafeDownCast(active))
  {
    return SeenGlyphs(*glyphs, shapes);
  }
  if (auto* slice = vtkImageSliceRepresentation::SafeDownCast(active))
  {
    return SeenSlice(*slice, shapes);
  }
  auto* geometry = vtkGeometryRepresentation::SafeDownCast(active);
  vtkPVLODActor* const actor = geometry ? geometry->GetActor() : nullptr;
  return { actor, { actor ? InputOf(actor->GetMapper()) : nullptr, {} } };
}

/// Of a server, where the mapper may have nothing here.
Seen SeenThere(vtkSMProxy* proxy, vtkObject* active, const vtkHapticRemoteSurfaces& remote)
{
  auto* geometry = vtkGeometryRepresentation::SafeDownCast(active);
  vtkPVLODActor* const actor = geometry ? geometry->GetActor() : nullptr;
  if (!geometry || vtkHapticRemoteSurfaces::Fetches(active))
  {
    return { actor, actor ? remote.ShapeOf(proxy) : vtkHapticShape() };
  }
  return { actor,
    { nullptr, active->IsA("vtkGlyph3DRepresentation")
                 ? "glyphs of a remote server cannot be touched; apply the filter Glyph and show its result"
                 : OnlyOutline } };
}

/// Others show a result of a curve, and nothing of it while it is drawn.
bool DrawsCurves(vtkObject* active)
{
  return !active->IsA("vtkOutlineRepresentation") && !active->IsA("vtkFeatureEdgesRepresentation");
}

/// The poly data that a mapper shows, also as the only piece of a composite; null if it shows more pieces or none.
vtkPolyData* OnlyPiece(vtkDataObject* shown)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(shown);
  if (!composite)
  {
    return vtkPolyData::SafeDownCast(shown);
  }
  auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  each->InitTraversal();
  auto* first = each->IsDoneWithTraversal() ? nullptr : vtkPolyData::SafeDownCast(each->GetCurrentDataObject());
  each->GoToNextItem();
  return each->IsDoneWithTraversal() ? first : nullptr;
}

bool SameCurve(vtkDataObject* a, vtkDataObject* b)
{
  vtkPolyData *const one = OnlyPiece(a), *const other = OnlyPiece(b);
  if (!one || !other || !one->GetPoints() || !other->GetPoints() ||
      one->GetLines()->GetNumberOfConnectivityIds() != other->GetLines()->GetNumberOfConnectivityIds())
  {
    return false;
  }
  const auto p = vtk::DataArrayValueRange(one->GetPoints()->GetData());
  const auto q = vtk::DataArrayValueRange(other->GetPoints()->GetData());
  return std::equal(p.begin(), p.end(), q.begin(), q.end());
}

/// A curve as its widget draws it, and once that was applied until `shown` has it too; else null.
vtkDataObject* DraftOf(vtkSMProxy* input, vtkDataObject* shown, vtkHapticDrafts& drafts)
{
  if (vtkDataObject* const changed = drafts.Changed(input))
  {
    return changed;
  }
  vtkDataObject* const applied = drafts.Knows(input) ? drafts.Drawn(input) : nullptr;
  if (applied && SameCurve(applied, shown))
  {
    drafts.Forget(input);
    return nullptr;
  }
  return applied;
}

/// False if it shows nothing that can be touched.
bool AddSurface(
  const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix, const Also& also, vtkHapticViewScan& scan)
{
  Surface surface;
  surface.Name = name;
  surface.Data = data;
  surface.GeometryKey = GeometryKey(data, also);
  if (surface.GeometryKey == 0)
  {
    return false;
  }
  surface.ArraysKey = vtkHapticArraysKey(data);
  surface.Matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  surface.Matrix->DeepCopy(matrix);
  scan.Surfaces.push_back(std::move(surface));
  return true;
}

/// Invisible data are not felt.
bool IsTransparent(vtkSMProxy* representation)
{
  vtkSMProperty* const opacity = representation->GetProperty("Opacity");
  return opacity && vtkSMPropertyHelper(opacity).GetAsDouble() <= 0.0;
}

void ScanRepresentation(
  vtkSMProxy* proxy, const std::string& name, const Also& also, vtkHapticShapes& shapes, vtkHapticViewScan& scan)
{
  vtkObject* active = vtkHapticActiveRepresentation(proxy);
  const Seen seen = also.Remote ? SeenThere(proxy, active, *also.Remote) : SeenOf(active, shapes);
  if (!seen.Actor || !seen.Shape.Problem.empty())
  {
    scan.Refusals.push_back(
      name + ": " + (seen.Actor ? seen.Shape.Problem : ReasonOf(proxy, WhyNoSurface(active))) + ".");
    return;
  }
  if (IsTransparent(proxy))
  {
    scan.Refusals.push_back(name + ": fully transparent; raise the opacity to touch this source.");
    return;
  }
  vtkDataObject* shown = seen.Shape.Data;
  if (also.Drafts && DrawsCurves(active))
  {
    vtkDataObject* const draft = DraftOf(vtkHapticInputOf(proxy), shown, *also.Drafts);
    shown = draft ? draft : shown;
  }
  if (!shown)
  {
    scan.Pending = true;
    return;
  }
  if (!AddSurface(name, shown, seen.Actor->GetMatrix(), also, scan))
  {
    scan.Refusals.push_back(name + ": " + ReasonOf(proxy, WhyNoPolygons(active, shown)) + ".");
    return;
  }
  scan.Surfaces.back().Part = also.Remote ? also.Remote->PartOf(proxy) : 0;
}

/// A curve that was not applied yet is where its widget is, in no actor.
void ScanDrawing(vtkSMProxy* drawing, const Also& also, vtkHapticDrafts& drafts, vtkHapticViewScan& scan)
{
  drafts.ForgetDeleted();
  const std::string name = vtkHapticNameOf(drawing);
  vtkDataObject* const drawn = name.empty() ? nullptr : drafts.Drawn(drawing);
  if (drawn && !AddSurface(name, drawn, vtkNew<vtkMatrix4x4>(), also, scan))
  {
    scan.Refusals.push_back(name + ": " + LinesNeedRadius + ".");
  }
}

/// Why nothing of this view can be touched; empty if it can.
std::string RefusalOf(vtkSMProxy* view)
{
  if (!view)
  {
    return "No view is active: click a 3D view.";
  }
  auto* render = vtkPVRenderView::SafeDownCast(view->GetClientSideObject());
  if (!render)
  {
    return "The active view is not a 3D render view: click a 3D view.";
  }
  return {};
}
} // namespace

vtkHapticViewScan vtkHapticScanView(vtkSMProxy* view, vtkHapticShapes& shapes, const vtkHapticScanOptions& options)
{
  vtkHapticViewScan scan;
  if (std::string refusal = RefusalOf(view); !refusal.empty())
  {
    scan.Refusals.push_back(std::move(refusal));
    return scan;
  }
  const bool remote = vtkHapticIsRemote(view);
  vtkHapticScanOptions here = options;
  here.Remote = remote ? options.Remote : nullptr;
  vtkSMProxy* drawing = options.Drawing;
  for (vtkSMProxy* const representation : vtkHapticVisibleRepresentations(view))
  {
    vtkSMProxy* const input = vtkHapticInputOf(representation);
    const std::string name = vtkHapticNameOf(input);
    drawing = input == drawing ? nullptr : drawing; // it is shown
    if (name.empty())
    {
      continue;
    }
    const vtkHapticViewScan::Source source = vtkHapticShownSource(representation, name);
    if ((source.Data || source.Remote) && !IsTransparent(representation))
    {
      scan.Sources.push_back(source);
    }
    ScanRepresentation(representation, name, here, shapes, scan);
  }
  if (options.Drafts && !remote)
  {
    ScanDrawing(drawing, options, *options.Drafts, scan);
  }
  return scan;
}
