# Without a display, whatever the user can mend is refused before anything is measured: one line on
# stderr that names it, status 2, and no file left behind.
function(expect_error message)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=DISPLAY ${BENCHMARK} ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE error)
  if(NOT result EQUAL 2 OR NOT output STREQUAL "" OR
     NOT error STREQUAL "limn_benchmark: error: ${message}\n")
    message(SEND_ERROR "${ARGN}: status ${result}, out \"${output}\", error \"${error}\"")
  endif()
endfunction()

expect_error("--only=nosuch: no scene's name contains this; --list prints the names" --only=nosuch)
expect_error("--only=nosuch: no scene's name contains this; --list prints the names"
  --only=nosuch --list)
expect_error("--only= has no value; see --help" --only= --list)
expect_error("--json= has no value; see --help" --json=)
set(advice "cannot be written; name a file in a folder that exists")
expect_error("${FOLDER}/none/report.json ${advice}" --json=${FOLDER}/none/report.json)
expect_error("${FOLDER}/none/scaling.json ${advice}" --scaling=${FOLDER}/none/scaling.json)
expect_error("${FOLDER} ${advice}" --json ${FOLDER})

set(report ${FOLDER}/never-written.json)
set(display "OpenGL needs an X display, and none can be opened; use ./dev bench, or run this by \
xvfb-run -a -s -noreset")
file(REMOVE ${report})
expect_error("${display}" --only=torus --json=${report})
if(EXISTS ${report})
  message(SEND_ERROR "An empty ${report} was left behind")
endif()
file(WRITE ${report} "earlier")
expect_error("${display}" --json=${report})
file(READ ${report} content)
if(NOT content STREQUAL "earlier")
  message(SEND_ERROR "${report} was changed to \"${content}\"")
endif()
file(REMOVE ${report})

foreach(arguments IN ITEMS --blocks=0 --unknown)
  execute_process(COMMAND ${BENCHMARK} ${arguments}
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE error)
  if(NOT result EQUAL 2 OR NOT error MATCHES "--(blocks|unknown)")
    message(SEND_ERROR "${arguments}: status ${result}, error \"${error}\"")
  endif()
endforeach()
execute_process(COMMAND ${BENCHMARK} --only=sheet --list RESULT_VARIABLE result
  OUTPUT_VARIABLE output)
if(NOT result EQUAL 0 OR NOT output STREQUAL "1 sheet 4K\n4 sheets 4K\n16 sheets 4K\n4 sheets 4K, translucent\n")
  message(SEND_ERROR "--only=sheet --list: status ${result}, \"${output}\"")
endif()
execute_process(COMMAND ${BENCHMARK} --help RESULT_VARIABLE result OUTPUT_VARIABLE output)
if(NOT result EQUAL 0 OR NOT output MATCHES "--blocks")
  message(SEND_ERROR "--help: status ${result}, \"${output}\"")
endif()
