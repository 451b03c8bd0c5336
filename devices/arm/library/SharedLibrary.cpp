// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/library/SharedLibrary.h"

#include <dlfcn.h>

namespace palpate
{

SharedLibrary::SharedLibrary(const std::string& name) : name_(name)
{
  void* const handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr)
  {
    const char* const why = dlerror();
    this->problem_ = "the vendor's library " + name + " cannot be loaded: install the vendor's software (" +
                     std::string(why != nullptr ? why : "no reason is given") + ')';
    return;
  }
  this->handle_ = std::shared_ptr<void>(handle, [](void* open) { dlclose(open); });
}

void* SharedLibrary::sought(const char* name) const
{
  return this->found() ? dlsym(this->handle_.get(), name) : nullptr;
}

void* SharedLibrary::address(const char* name)
{
  void* const found = this->sought(name);
  if (found == nullptr && this->problem_.empty())
  {
    this->problem_ = "the vendor's library " + this->name_ + " has no function " + name + ": install a newer version";
  }
  return found;
}

} // namespace palpate
