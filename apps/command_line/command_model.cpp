#include "command_line/command_model.hpp"

#include <CLI/CLI.hpp>

namespace taut::cli {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

OptionModel option_model(const CLI::Option& option) {
  OptionModel model;
  for (const std::string& name : option.get_snames()) model.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) model.names.push_back("--" + name);
  if (model.names.empty()) model.positional = option.get_name();
  // A value that may be left out stands in the option's own word: none follows.
  if (option.get_items_expected_max() > 0 && option.get_expected_min() > 0) model.value = option.get_option_text();
  if (model.value.find('|') != std::string::npos) model.choices = split(model.value, '|');
  model.description = option.get_description();
  return model;
}

CommandModel model_of(const CLI::App& app, const std::string& name) {
  CommandModel model{name, app.get_description(), app.get_footer(), {}, {}};
  for (const CLI::Option* option : app.get_options()) model.options.push_back(option_model(*option));
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    model.commands.push_back(model_of(*command, name + " " + command->get_name()));
  }
  return model;
}

}  // namespace

CommandModel command_model(const Command& taut) { return model_of(taut.app(), "taut"); }

}  // namespace taut::cli
