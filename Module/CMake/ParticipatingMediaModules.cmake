# Finds VTK and GLM, then scans, builds, wraps and installs the two VTK modules.

set(participating_media_vtk_components
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms
  RenderingCore RenderingOpenGL2 RenderingVolume RenderingVolumeOpenGL2)
if(PARTICIPATING_MEDIA_WRAP_PYTHON)
  list(APPEND participating_media_vtk_components WrappingPythonCore Python)
endif()
# What only examples and tests use, and the OpenGL loader, whose name changed in VTK 9.4.
find_package(VTK 9.1 REQUIRED
  COMPONENTS ${participating_media_vtk_components}
  OPTIONAL_COMPONENTS glad glew InteractionStyle ImagingCore ImagingHybrid FiltersModeling
    IOImage IOXML RenderingFreeType TestingCore TestingRendering)
find_package(glm CONFIG REQUIRED)

vtk_module_find_modules(participating_media_module_files
  "${CMAKE_CURRENT_SOURCE_DIR}/Module" "${CMAKE_CURRENT_SOURCE_DIR}/Rendering")
vtk_module_scan(
  MODULE_FILES ${participating_media_module_files}
  REQUEST_MODULES ParticipatingMedia::Medium ParticipatingMedia::Rendering
  PROVIDES_MODULES participating_media_modules
  WANT_BY_DEFAULT ON
  ENABLE_TESTS OFF)

# The mapper finds VTK's OpenGL factories by auto-initialisation also from the wrappers.
set_property(GLOBAL PROPERTY _vtk_module_autoinit_include "${VTK_AUTOINIT_INCLUDE}")

if(SKBUILD)
  # A wheel: everything in one folder, found from there, and no symbolic links.
  set(CMAKE_INSTALL_RPATH "$ORIGIN")
  vtk_module_build(
    MODULES ${participating_media_modules}
    LIBRARY_DESTINATION participating_media
    INSTALL_HEADERS OFF)
  vtk_module_wrap_python(
    MODULES ${participating_media_modules}
    PYTHON_PACKAGE participating_media
    MODULE_DESTINATION "."
    INSTALL_HEADERS OFF
    BUILD_STATIC OFF)
  return()
endif()

# Installed, the libraries find each other, wherever the install tree is moved to.
set(CMAKE_INSTALL_RPATH "$ORIGIN")
vtk_module_build(
  MODULES ${participating_media_modules}
  PACKAGE ParticipatingMedia
  INSTALL_EXPORT ParticipatingMedia
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/ParticipatingMedia"
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/ParticipatingMedia"
  LIBRARY_NAME_SUFFIX ""
  VERSION "${PROJECT_VERSION}"
  SOVERSION "${PROJECT_VERSION_MAJOR}")

if(PARTICIPATING_MEDIA_WRAP_PYTHON)
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
  vtk_module_python_default_destination(participating_media_python_destination)
  file(RELATIVE_PATH participating_media_libraries
    "/${participating_media_python_destination}/participating_media" "/${CMAKE_INSTALL_LIBDIR}")
  set(CMAKE_INSTALL_RPATH "$ORIGIN/${participating_media_libraries}")
  vtk_module_wrap_python(
    MODULES ${participating_media_modules}
    PYTHON_PACKAGE participating_media
    MODULE_DESTINATION "${participating_media_python_destination}"
    CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/ParticipatingMedia"
    INSTALL_HEADERS OFF
    BUILD_STATIC OFF)
  set(PARTICIPATING_MEDIA_PYTHONPATH "${CMAKE_BINARY_DIR}/${participating_media_python_destination}")
  file(GLOB participating_media_python_sources CONFIGURE_DEPENDS
    "${CMAKE_CURRENT_SOURCE_DIR}/Module/Python/participating_media/*.py"
    "${CMAKE_CURRENT_SOURCE_DIR}/Module/Python/participating_media/py.typed")
  foreach(source IN LISTS participating_media_python_sources)
    get_filename_component(name "${source}" NAME)
    configure_file("${source}"
      "${PARTICIPATING_MEDIA_PYTHONPATH}/participating_media/${name}" COPYONLY)
  endforeach()
  # A Python that sees the package of this build tree, and the sanitizers' run time if need be.
  set(participating_media_preload)
  if(PARTICIPATING_MEDIA_SANITIZE)
    execute_process(COMMAND "${CMAKE_CXX_COMPILER}" -print-file-name=libasan.so
      OUTPUT_VARIABLE participating_media_preload OUTPUT_STRIP_TRAILING_WHITESPACE)
  endif()
  configure_file("${CMAKE_CURRENT_SOURCE_DIR}/Module/Python/python.in"
    "${CMAKE_BINARY_DIR}/python" @ONLY)
  set(PARTICIPATING_MEDIA_PYTHON "${CMAKE_BINARY_DIR}/python")

  install(FILES ${participating_media_python_sources}
    DESTINATION "${participating_media_python_destination}/participating_media")
endif()

include(CMakePackageConfigHelpers)
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/ParticipatingMediaConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/cmake/ParticipatingMedia/ParticipatingMediaConfig.cmake"
  INSTALL_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/ParticipatingMedia")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/cmake/ParticipatingMedia/ParticipatingMediaConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/cmake/ParticipatingMedia/ParticipatingMediaConfig.cmake"
  "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/cmake/ParticipatingMedia/ParticipatingMediaConfigVersion.cmake"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/ParticipatingMedia")
