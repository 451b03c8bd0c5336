// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticToolLine.h"

#include "pqActiveObjects.h"
#include "pqHapticLink.h"
#include "pqLinePropertyWidget.h"
#include "pqPipelineSource.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkBoundingBox.h"
#include "vtkHapticToolHandle.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMViewProxy.h"

#include <algorithm>
#include <array>

namespace
{
using Point = std::array<double, 3>;

Point PointOf(vtkSMProxy* session, const char* property)
{
  Point point{};
  vtkSMPropertyHelper(session, property).Get(point.data(), 3);
  return point;
}

/// Where a handle may be that was placed for this tool, and not for another.
bool IsNear(const Point& handle, vtkBoundingBox box)
{
  box.Inflate(box.GetDiagonalLength());
  return box.ContainsPoint(handle.data());
}

/// Ends of the longest side of a box, through its middle.
void PlaceIn(const vtkBoundingBox& box, vtkSMProxy* session)
{
  Point handle{}, tip{}, lengths{};
  box.GetCenter(handle.data());
  box.GetLengths(lengths.data());
  const auto longest = static_cast<int>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
  tip = handle;
  handle[longest] = box.GetBound(2 * longest + 1);
  tip[longest] = box.GetBound(2 * longest);
  vtkSMPropertyHelper(session, "ToolHandlePoint").Set(handle.data(), 3);
  vtkSMPropertyHelper(session, "ToolTipPoint").Set(tip.data(), 3);
}

void SetShown(pqPipelineSource* source, pqView* view, bool shown)
{
  if (!source || !view)
  {
    return;
  }
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  shown ? static_cast<void>(controller->Show(source->getSourceProxy(), 0, view->getViewProxy()))
        : static_cast<void>(controller->Hide(source->getSourceProxy(), 0, view->getViewProxy()));
  view->render();
}
} // namespace

pqHapticToolLine::pqHapticToolLine(QWidget* parent) : Superclass(parent), Panel(parent) {}

pqHapticToolLine::~pqHapticToolLine() = default;

void pqHapticToolLine::show(vtkSMProxy* session, pqPipelineSource* tool)
{
  this->Session = session;
  this->Tool = tool;
  {
    SCOPED_UNDO_SET(pqHapticStepName(*session, "ToolHandle"));
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", session);
    const vtkBoundingBox box(tool->getSourceProxy()->GetDataInformation(0)->GetBounds());
    const Point handle = PointOf(session, "ToolHandlePoint");
    if (handle == PointOf(session, "ToolTipPoint") || !IsNear(handle, box))
    {
      PlaceIn(box, session);
    }
    vtkSMPropertyHelper(session, "ToolHandle").Set(static_cast<int>(vtkHapticToolHandle::Handle));
    session->UpdateVTKObjects();
  }
  this->View = pqActiveObjects::instance().activeView();
  SetShown(tool, this->View, true);
  vtkNew<vtkSMPropertyGroup> ends;
  ends->AddProperty("Point1WorldPosition", session->GetProperty("ToolHandlePoint"));
  ends->AddProperty("Point2WorldPosition", session->GetProperty("ToolTipPoint"));
  this->Line = new pqLinePropertyWidget(session, ends, this->Panel);
  this->Line->hide(); // the panel has rows of its own for the two points
  this->connect(this->Line, &pqPropertyWidget::changeFinished, this, &pqHapticToolLine::apply);
  this->Line->setDataSource(tool->getSourceProxy());
  this->Line->setView(this->View);
  this->Line->reset();
  this->Line->select();
}

void pqHapticToolLine::hide()
{
  delete this->Line;
  SetShown(this->Tool, this->View, false);
}

void pqHapticToolLine::apply()
{
  if (!this->Session)
  {
    return;
  }
  SCOPED_UNDO_SET(tr("Handle and tip"));
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", this->Session.Get());
  this->Line->apply();
  this->Session->UpdateVTKObjects();
}
