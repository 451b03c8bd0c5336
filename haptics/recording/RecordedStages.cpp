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

template<class Object, class Fields>
void getFields(NamedPart& stage, Object& object, const Fields& fields)
{
  eachPart(stage.payload,
    [&](NamedPart& field)
    {
      bool known = false;
      fields(GetField{ field, known }, object);
      field.payload.failUnless(known);
    });
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

/// Fills an object from parts, stage by stage; a part without a member fails.
template<class Object, class ForEach>
void getStages(ByteReader& in, Object& object, const ForEach& forEachStage)
{
  eachPart(in,
    [&](NamedPart& stage)
    {
      bool known = false;
      forEachStage(
        [&](std::string_view name, const auto& fields)
        {
          if (stage.name == name)
          {
            known = true;
            getFields(stage, object, fields);
          }
        });
      stage.payload.failUnless(known);
    });
}

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

void getParameters(ByteReader& in, HapticParameters& parameters)
{
  getStages(in, parameters, [](const auto& function) { forEachPlan(function); });
}

void getState(ByteReader& in, RendererState& state)
{
  getStages(in, state, [](const auto& function) { forEachState(function); });
}

} // namespace palpate
