// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticLink_h
#define pqHapticLink_h

#include "pqPropertyLinksConnection.h"

#include <QString>

class pqPropertyLinks;

/// Links a field and a setting of the session both ways. A change of the field is traced, and is one step of undo that
/// has the title of the setting.
class pqHapticLink : public pqPropertyLinksConnection
{
  Q_OBJECT
  typedef pqPropertyLinksConnection Superclass;

public:
  /// As pqPropertyLinks makes its links: `links` is one.
  pqHapticLink(QObject* field, const char* value, const char* changed, vtkSMProxy* session, vtkSMProperty* setting,
    int element, bool unchecked, QObject* links);
  ~pqHapticLink() override;

  /// `value` and `changed`: the field's property and signal of Qt; `element`: of a setting of several numbers, else -1.
  static void add(pqPropertyLinks& links, QObject* field, const char* value, const char* changed, vtkSMProxy* session,
    const char* setting, int element = -1);

protected:
  void setServerManagerValue(bool unchecked, const QVariant& value) override;

private:
  void endStep();

  bool Begun = false; ///< a step of undo, which ends after the session was told
};

/// The name of an undo step that changes a setting: its title without a mnemonic, or its label where it has no title.
[[nodiscard]] QString pqHapticStepName(const vtkSMProxy& session, const char* setting);

#endif
