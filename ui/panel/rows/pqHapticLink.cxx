// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticLink.h"

#include "pqHapticFields.h"
#include "pqPropertyLinks.h"
#include "pqUndoStack.h"

QString pqHapticStepName(const vtkSMProxy& session, const char* setting)
{
  const QString title = pqHapticTitle(setting).remove('&');
  return title.isEmpty() ? QString(const_cast<vtkSMProxy&>(session).GetProperty(setting)->GetXMLLabel()) : title;
}

void pqHapticLink::add(pqPropertyLinks& links, QObject* field, const char* value, const char* changed,
  vtkSMProxy* session, const char* setting, int element)
{
  links.addTraceablePropertyLink<pqHapticLink>(field, value, changed, session, session->GetProperty(setting), element);
}

pqHapticLink::pqHapticLink(QObject* field, const char* value, const char* changed, vtkSMProxy* session,
  vtkSMProperty* setting, int element, bool unchecked, QObject* links)
  : Superclass(field, value, changed, session, setting, element, unchecked, links)
{
  this->connect(static_cast<pqPropertyLinks*>(links), &pqPropertyLinks::qtWidgetChanged, this, &pqHapticLink::endStep);
}

pqHapticLink::~pqHapticLink()
{
  this->endStep();
}

void pqHapticLink::endStep()
{
  if (this->Begun)
  {
    this->Begun = false;
    END_UNDO_SET();
  }
}

void pqHapticLink::setServerManagerValue(bool unchecked, const QVariant& value)
{
  vtkSMProxy* const session = this->proxySM();
  const char* const setting = session->GetPropertyName(this->propertySM());
  this->endStep();
  this->Begun = true;
  BEGIN_UNDO_SET(pqHapticStepName(*session, setting));
  this->Superclass::setServerManagerValue(unchecked, value); // the links tell the session next
}
