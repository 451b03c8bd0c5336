// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticSourceTexts.h"

#include "pqApplicationCore.h"
#include "pqHapticStatusBar.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

pqHapticSourceTexts::pqHapticSourceTexts(QObject* parent) : Superclass(parent)
{
  this->connect(pqApplicationCore::instance()->getServerManagerModel(), &pqServerManagerModel::dataUpdated, this,
    &pqHapticSourceTexts::say);
}

void pqHapticSourceTexts::say(pqPipelineSource* source) const
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
