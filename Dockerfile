# An image with OpenFOAM v1912 of Debian 12 and this project built in it:
#
#   docker build -t deformableparticles .
#   docker run --rm -it deformableparticles
#
# The commands after RUN are those of doc/install.md for root; a test compares them.
FROM debian:12

COPY . /opt/deformableParticles
WORKDIR /opt/deformableParticles

RUN bin/install-openfoam
RUN ./Allwmake

# A shell with the environment of OpenFOAM; tutorials/README.md is the course
CMD ["bash", "-c", ". bin/openfoam-env && foamEnvironment; exec bash"]
