// SPDX-License-Identifier: GPL-3.0-or-later
// Palpate.so is linked to no library of ParaView. ParaView says of a plugin whose libraries are not there that there is
// a problem and no more, so this file looks which ParaView runs before it opens the plugin proper, PalpatePlugin.so
// beside it.
#include <dlfcn.h>
#include <link.h>

#include <cstdio>
#include <string>
#include <string_view>

class vtkPVPlugin;

namespace
{
/// The series of the ParaView that runs, as "5.11", from the name of a library that every program of ParaView has; ""
/// where there is none.
std::string RunningSeries()
{
  constexpr auto visit = [](dl_phdr_info* object, std::size_t, void* found)
  {
    constexpr std::string_view before = "libvtkRemotingCore-pv";
    const std::string_view path = object->dlpi_name;
    const std::size_t at = path.find(before);
    if (at == std::string_view::npos)
    {
      return 0;
    }
    const std::string_view rest = path.substr(at + before.size());
    *static_cast<std::string*>(found) = rest.substr(0, rest.find(".so"));
    return 1;
  };
  std::string series;
  dl_iterate_phdr(visit, &series);
  return series;
}

/// In VTK's output window, where there is one: a person who starts ParaView from a menu sees no other.
void Say(const std::string& sentence)
{
  using Display = void (*)(const char*);
  if (const auto display = reinterpret_cast<Display>(dlsym(RTLD_DEFAULT, "_Z31vtkOutputWindowDisplayErrorTextPKc")))
  {
    display((sentence + "\n").c_str());
    return;
  }
  std::fprintf(stderr, "%s\n", sentence.c_str());
}

std::string PluginBesideThis()
{
  Dl_info own{};
  dladdr(reinterpret_cast<const void*>(&RunningSeries), &own);
  const std::string path = own.dli_fname ? own.dli_fname : "";
  return path.substr(0, path.rfind('/') + 1) + "PalpatePlugin.so";
}
} // namespace

/// The plugin, for ParaView. Null where the series of ParaView is another, or where the plugin cannot be opened: the
/// reason is said.
extern "C" __attribute__((visibility("default"))) vtkPVPlugin* pv_plugin_instance()
{
  if (const std::string series = RunningSeries(); series != PALPATE_PARAVIEW)
  {
    Say("Palpate: this plugin was built for ParaView " PALPATE_PARAVIEW ", and this is ParaView " + series +
        ". Install the package for this ParaView, or build Palpate with it: docs/releases.md says how.");
    return nullptr;
  }
  void* plugin = dlopen(PluginBesideThis().c_str(), RTLD_NOW);
  using Instance = vtkPVPlugin* (*)();
  const auto instance = plugin ? reinterpret_cast<Instance>(dlsym(plugin, "pv_plugin_instance")) : nullptr;
  if (!instance)
  {
    const char* reason = dlerror();
    Say("Palpate: the plugin cannot be opened: " + std::string(reason ? reason : "it is not a plugin"));
    return nullptr;
  }
  return instance();
}
