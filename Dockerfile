# An image with OpenFOAM v1912 of Debian 12 and this project built in it:
#
#   docker build -t deformableparticles .
#   docker run --rm -it deformableparticles
#
# The commands after RUN are those for a fresh root of Debian 12, without Docker, too.
FROM debian:12

COPY . /opt/deformableParticles
WORKDIR /opt/deformableParticles

RUN bin/install-openfoam
RUN ./Allwmake > log.Allwmake 2>&1 || { tail -n 30 log.Allwmake; exit 1; }

# A shell with the environment of OpenFOAM; tutorials/README.md is the course
CMD ["bash", "-c", ". bin/openfoam-env && foamEnvironment; exec bash"]
