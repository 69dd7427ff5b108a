# Run as a script: writes what PROGRAM says of itself below FOLDER: manual pages, completions, the schema and the
# annotations for editors.
function(describe file)
  get_filename_component(folder ${FOLDER}/${file} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${FOLDER}/${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${FOLDER})
describe(share/flyrock/scenario.schema.json schema)
describe(share/flyrock/annotations/flyrock.lua schema --lua)
describe(share/bash-completion/completions/flyrock completion bash)
# Two places: where zsh of Debian looks, and where others do.
describe(share/zsh/vendor-completions/_flyrock completion zsh)
describe(share/zsh/site-functions/_flyrock completion zsh)
describe(share/man/man1/flyrock.1 man)
execute_process(COMMAND ${PROGRAM} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n  flyrock [a-z]+" commands "${help}")
foreach(command ${commands})
  string(REGEX REPLACE ".* " "" command "${command}")
  describe(share/man/man1/flyrock-${command}.1 man ${command})
endforeach()
file(TOUCH ${FOLDER}/.stamp)
