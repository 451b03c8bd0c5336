// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFeltSource_h
#define vtkHapticFeltSource_h

#include <string>

namespace palpate
{
class HapticSession;
struct HapticState;
} // namespace palpate

class vtkDataObject;

/// A source of the pipeline that a session feels as one kind of thing, by a worker of its core: its name, its converted
/// data, its status. A kind converts data, and says how it is felt.
class vtkHapticFeltSource
{
public:
  virtual ~vtkHapticFeltSource() = default;

  std::string Source; ///< that is asked for; "": none
  std::string Text;   ///< how it is felt, or why it is not; "" without a source

  virtual const char* Setting() const = 0; ///< that names the source
  virtual const char* Subject() const = 0; ///< of its problems
  virtual bool IsHeld() const = 0;         ///< in the hand: no surface of it is touched
  /// Takes the data of a source; null: the source is not there, or has made nothing for that reason. Empty, or why it
  /// cannot be felt; then nothing is.
  std::string Take(const std::string& name, vtkDataObject* data, const std::string& reason)
  {
    this->Name = name;
    this->Problem = this->Convert(data, reason);
    return this->Problem;
  }
  const std::string& Taken() const { return this->Name; } ///< of which source
  /// Has the core feel it, from a tick soon after on.
  virtual void Choose(palpate::HapticSession& core) const = 0;
  /// Why the core does not feel the choice; "": it does.
  virtual std::string Refusal(const palpate::HapticSession& /*core*/) const { return {}; }
  /// How it is at that time, after each look at the session.
  void Follow(palpate::HapticSession& core, const palpate::HapticState& state, double now_s)
  {
    this->Look(core, state, now_s);
    this->Text = this->Source.empty()     ? ""
                 : !this->Problem.empty() ? this->Problem
                 : this->IsMade()         ? this->Sentence(core, state)
                 : this->Name.empty()     ? this->Source + this->Chosen(core)
                                          : this->Source + this->Absent();
  }

protected:
  virtual std::string Convert(vtkDataObject* data, const std::string& reason) = 0;
  virtual bool IsMade() const = 0;
  virtual void Look(palpate::HapticSession& core, const palpate::HapticState& state, double now_s) = 0;
  /// Of converted data.
  virtual std::string Sentence(palpate::HapticSession& core, const palpate::HapticState& state) const = 0;
  /// Of a source that was chosen and not looked for yet.
  static const char* Chosen(const palpate::HapticSession& core);
  virtual const char* Absent() const = 0; ///< the remedy, after the name of a source that is not there

  std::string Name;
  std::string Problem; ///< why nothing is made of the data
};

#endif
