// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticMeasuring.h"

#include "pqApplicationCore.h"
#include "pqHapticController.h"
#include "pqHapticStatusBar.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "vtkHapticInspection.h"
#include "vtkHapticSession.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <cstring>

pqHapticMeasuring::pqHapticMeasuring(pqHapticController* controller) : Superclass(controller), Controller(controller)
{
  auto* const model = pqApplicationCore::instance()->getServerManagerModel();
  this->connect(model, &pqServerManagerModel::sourceAdded, this, &pqHapticMeasuring::beginAtContact);
  this->connect(model, &pqServerManagerModel::dataUpdated, this, &pqHapticMeasuring::say);
}

void pqHapticMeasuring::beginAtContact(pqPipelineSource* source) const
{
  vtkSMProxy* const proxy = source->getProxy();
  vtkHapticSession* const session = this->Controller->session();
  if (std::strcmp(proxy->GetXMLName(), "HapticSurfaceMap") != 0 || !session || !session->InspectContact())
  {
    return;
  }
  vtkSMPropertyHelper centre(proxy, "Centre");
  double at[3];
  centre.Get(at, 3);
  if (at[0] == 0.0 && at[1] == 0.0 && at[2] == 0.0) // else a state or a script has set the place
  {
    session->GetInspection()->GetContactInData(at);
    centre.Set(at, 3);
  }
}

void pqHapticMeasuring::say(pqPipelineSource* source) const
{
  vtkSMProxy* const proxy = source->getProxy();
  vtkPVXMLElement* const hints = proxy->GetHints();
  if (!hints || !hints->FindNestedElementByName("StatusBar"))
  {
    return;
  }
  proxy->UpdatePropertyInformation(proxy->GetProperty("Text"));
  const QString sentence = vtkSMPropertyHelper(proxy, "Text").GetAsString();
  if (!sentence.isEmpty())
  {
    pqHapticSayInStatusBar(sentence);
  }
}
