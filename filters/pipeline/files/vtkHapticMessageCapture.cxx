// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMessageCapture.h"

#include <algorithm>
#include <string_view>

#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

namespace
{
/// "ERROR: In file.cxx, line 12\nvtkClass (0x55): message\n\n" becomes "message".
std::string Essence(std::string_view text)
{
  constexpr std::string_view preamble = "): ";
  const std::size_t start = text.find(preamble);
  std::string essence(start == std::string_view::npos ? text : text.substr(start + preamble.size()));
  std::replace_if(
    essence.begin(), essence.end(), [](unsigned char c) { return c < 0x20; }, ' ');
  const std::size_t last = essence.find_last_not_of(" .");
  essence.erase(last == std::string::npos ? 0 : last + 1);
  return essence;
}
} // namespace

class vtkHapticMessageCapture::Window : public vtkOutputWindow
{
public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow);

  void DisplayErrorText(const char* text) override { Keep(this->Error, text); }
  void DisplayWarningText(const char* text) override { Keep(this->Warning, text); }
  void DisplayGenericWarningText(const char* text) override { Keep(this->Warning, text); }
  void DisplayDebugText(const char*) override {}
  void DisplayText(const char*) override {}

  std::string Error;
  std::string Warning;

private:
  static void Keep(std::string& first, const char* text)
  {
    if (first.empty() && text)
    {
      first = Essence(text);
    }
  }
};

vtkStandardNewMacro(vtkHapticMessageCapture::Window);

vtkHapticMessageCapture::vtkHapticMessageCapture()
  : Previous(vtkOutputWindow::GetInstance()), PreviousVerbosity(vtkLogger::GetCurrentVerbosityCutoff()),
    Current(vtkSmartPointer<Window>::New())
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // the log repeats on stderr the messages to the window
  vtkOutputWindow::SetInstance(this->Current);
}

vtkHapticMessageCapture::~vtkHapticMessageCapture()
{
  vtkOutputWindow::SetInstance(this->Previous);
  vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(this->PreviousVerbosity));
}

const std::string& vtkHapticMessageCapture::FirstError() const
{
  return this->Current->Error;
}

const std::string& vtkHapticMessageCapture::FirstWarning() const
{
  return this->Current->Warning;
}
