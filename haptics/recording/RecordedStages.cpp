// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordedStages.h"

#include "haptics/recording/NamedParts.h"
#include "haptics/tick/StageFields.h"

namespace palpate
{
namespace
{

struct CopyField
{
  template<class T>
  void operator()(const char* /*name*/, T& to, const T& from) const noexcept
  {
    to = from;
  }
};

struct PutField
{
  ByteWriter& out;

  template<class T>
  void operator()(const char* name, const T& value) const
  {
    ByteWriter bytes;
    bytes.put(value);
    putPart(this->out, name, bytes);
  }
};

/// Gets the value of the member that has the field's name.
struct GetField
{
  NamedPart& field;
  bool& known;

  template<class T>
  void operator()(const char* name, T& value) const
  {
    if (this->field.name == name)
    {
      this->field.payload.get(value);
      this->field.payload.failUnless(this->field.payload.left() == 0);
      this->known = true;
    }
  }
};

/// Calls a function with each part of the bytes.
template<class Function>
void eachPart(ByteReader& in, const Function& function)
{
  while (in.ok() && in.left() > 0)
  {
    NamedPart part = nextPart(in);
    if (in.ok())
    {
      function(part);
      in.failUnless(part.payload.ok());
    }
  }
}

template<class Object>
auto putStage(ByteWriter& out, const Object& object)
{
  return [&out, &object](std::string_view name, const auto& fields)
  {
    ByteWriter stage;
    fields(PutField{ stage }, object);
    putPart(out, name, stage);
  };
}

/// Fills one object from parts, stage by stage.
template<class Object>
class StageGetter
{
public:
  StageGetter(Object& object, SkippedParts& skipped) : object_(object), skipped_(skipped) {}

  template<class ForEach>
  void get(ByteReader& in, const ForEach& forEachStage)
  {
    eachPart(in,
      [this, &forEachStage](NamedPart& part)
      {
        bool known = false;
        forEachStage(
          [this, &part, &known](std::string_view name, const auto& fields)
          {
            if (part.name == name)
            {
              known = true;
              this->getFields(part, fields);
            }
          });
        this->noteUnless(known, part.name);
      });
  }

private:
  template<class Fields>
  void getFields(NamedPart& stage, const Fields& fields)
  {
    eachPart(stage.payload,
      [this, &stage, &fields](NamedPart& field)
      {
        bool known = false;
        fields(GetField{ field, known }, this->object_);
        this->noteUnless(known, stage.name + "." + field.name);
      });
  }

  void noteUnless(bool known, const std::string& name)
  {
    if (!known)
    {
      this->skipped_.note(name);
    }
  }

  Object& object_;
  SkippedParts& skipped_;
};

} // namespace

void putParameters(ByteWriter& out, const HapticParameters& parameters)
{
  forEachPlan(putStage(out, parameters));
}

void putState(ByteWriter& out, const RendererState& state)
{
  forEachState(putStage(out, state));
}

RendererState recordedPart(const RendererState& state) noexcept
{
  RendererState part;
  forEachState([&part, &state](std::string_view /*name*/, const auto& fields) { fields(CopyField{}, part, state); });
  return part;
}

void getParameters(ByteReader& in, HapticParameters& parameters, SkippedParts& skipped)
{
  StageGetter(parameters, skipped).get(in, [](const auto& function) { forEachPlan(function); });
}

void getState(ByteReader& in, RendererState& state, SkippedParts& skipped)
{
  StageGetter(state, skipped).get(in, [](const auto& function) { forEachState(function); });
}

} // namespace palpate
