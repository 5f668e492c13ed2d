# Builds the Debian package on Debian 12, and installs it in an image without compilers (docs/installing.md).
FROM debian:12 AS build
COPY scripts/install_dependencies /social_crowd/scripts/
RUN /social_crowd/scripts/install_dependencies package
COPY . /social_crowd
RUN mkdir /packages && /social_crowd/scripts/package --output /packages

FROM debian:12-slim
COPY --from=build /packages /packages
RUN apt-get update \
  && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends /packages/ros-social-crowd_*.deb \
  && rm -rf /packages /var/lib/apt/lists/* \
  && useradd --create-home crowd
USER crowd
WORKDIR /home/crowd
CMD ["roslaunch", "social_crowd", "demo.launch", "rviz:=false"]
